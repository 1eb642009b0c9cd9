#!/usr/bin/env python3
"""Clients that a simulator must survive, written from the description of the player API alone.

    hostile_client.py KIND PORT SECONDS

KIND: silent, never_reads, one_byte_a_second, four_gibibytes, random_bytes, half_frames, nan, flood, reconnects, stopped
"""
import os
import random
import signal
import socket
import struct
import sys
import time


def field(number, kind, payload):
    return bytes(varint(number << 3 | kind)) + payload


def varint(value):
    out = []
    while value >= 128:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes(out + [value])


def text(number, value):
    return field(number, 2, varint(len(value)) + value)


def frame(message):
    return struct.pack(">I", len(message)) + message


def position(motor, value):
    return text(1, text(1, motor) + field(2, 1, struct.pack("<d", value)))


def time_step(sensor, milliseconds):
    return text(6, text(1, sensor) + field(2, 0, varint(milliseconds)))


def connect(port, until):
    while time.time() < until:
        try:
            return socket.create_connection(("127.0.0.1", port), timeout=5)
        except OSError:
            time.sleep(0.02)
    sys.exit(0)


def silent(s, until):
    while time.time() < until:
        if not s.recv(1 << 20):
            return


def never_reads(s, until):
    s.sendall(frame(time_step(b"head", 48) + time_step(b"neck_sensor", 8)))
    time.sleep(max(0, until - time.time()))


def one_byte_a_second(s, until):
    for byte in frame(position(b"head_pan", 0.1)):
        if time.time() > until:
            return
        s.sendall(bytes([byte]))
        time.sleep(1)


def four_gibibytes(s, until):
    s.sendall(b"\xff\xff\xff\xff" + b"x" * 1000)
    silent(s, until)


def random_bytes(s, until):
    chance = random.Random(7)
    while time.time() < until:
        s.sendall(chance.randbytes(4096))


def half_frames(s, until):
    while time.time() < until:
        s.sendall(frame(position(b"head_pan", 0.1))[:9])
        s.close()
        s = connect(s_port, until)


def nan(s, until):
    s.settimeout(None)
    while time.time() < until:
        s.sendall(frame(position(b"head_pan", float("nan")) + position(b"no_such_motor", 1e308)))
        s.recv(1 << 20)


def flood(s, until):
    message = frame(time_step(b"head_pan_sensor", 8)) * 100
    while time.time() < until:
        s.sendall(message)


def reconnects(s, until):
    while time.time() < until:
        s.close()
        s = connect(s_port, until)


def stopped(s, until):
    s.sendall(frame(time_step(b"head_pan_sensor", 8)))
    if os.fork() == 0:
        time.sleep(max(0, until - time.time()))
        os.kill(os.getppid(), signal.SIGCONT)
        os._exit(0)
    os.kill(os.getpid(), signal.SIGSTOP)


if __name__ == "__main__":
    kind, s_port, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
    end = time.time() + seconds
    while time.time() < end:
        try:
            globals()[kind](connect(s_port, end), end)
        except OSError:
            pass  # cut off: comes again
