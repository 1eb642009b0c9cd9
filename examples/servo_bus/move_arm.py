#!/usr/bin/env python3
"""Moves the right arm of a KS21 over a servo bus, as one would move a robot of metal: move_arm.py /tmp/murosimf/red.1

Written from the manual of Dynamixel protocol 2.0 alone, without any library. Servo 4 is the shoulder, 6 the elbow,
241 the board with the inertial measurement unit. docs/servo_bus.md has the scenario.
"""

import math
import os
import select
import struct
import sys
import time

PING, READ, WRITE, SYNC_READ, SYNC_WRITE, STATUS, ALL = 0x01, 0x02, 0x03, 0x82, 0x83, 0x55, 0xFE
TORQUE_ENABLE, PROFILE_VELOCITY, GOAL_POSITION, PRESENT_POSITION = 64, 112, 116, 132
SHOULDER, ELBOW, BOARD = 4, 6, 241
GOALS = {SHOULDER: -1.0, ELBOW: -0.8}  # [rad]


def crc(data):
    value = 0
    for byte in data:
        value ^= byte << 8
        for _ in range(8):
            value = (value << 1) ^ 0x8005 if value & 0x8000 else value << 1
    return value & 0xFFFF


def packet(servo, instruction, parameters=b""):
    body = bytes([instruction]) + parameters
    data = b"\xff\xff\xfd\x00" + struct.pack("<BH", servo, len(body) + 2) + body.replace(b"\xff\xff\xfd", b"\xff\xff\xfd\xfd")
    return data + struct.pack("<H", crc(data))


class Bus:
    def __init__(self, path):
        self.port = os.open(path, os.O_RDWR | os.O_NOCTTY)
        self.bytes = b""

    def send(self, *question):
        os.write(self.port, packet(*question))

    def take(self, count):
        deadline = time.monotonic() + 1
        while len(self.bytes) < count:
            if not select.select([self.port], [], [], max(0, deadline - time.monotonic()))[0]:
                raise TimeoutError(f"no answer within a second, {len(self.bytes)} of {count} bytes")
            self.bytes += os.read(self.port, 4096)
        taken, self.bytes = self.bytes[:count], self.bytes[count:]
        return taken

    def answer(self):
        """Id and data of the next status packet."""
        head = self.take(7)
        assert head[:4] == b"\xff\xff\xfd\x00", head
        rest = self.take(struct.unpack("<H", head[5:7])[0])
        assert crc(head + rest[:-2]) == struct.unpack("<H", rest[-2:])[0], "checksum"
        body = rest[:-2].replace(b"\xff\xff\xfd\xfd", b"\xff\xff\xfd")
        assert body[0] == STATUS and body[1] == 0, f"servo {head[4]}: error {body[1]}"
        return head[4], body[2:]

    def sync_write(self, address, values):
        data = b"".join(struct.pack("<Bi", servo, value) for servo, value in values.items())
        self.send(ALL, SYNC_WRITE, struct.pack("<HH", address, 4) + data)

    def sync_read(self, address, servos):
        self.send(ALL, SYNC_READ, struct.pack("<HH", address, 4) + bytes(servos))
        return {servo: struct.unpack("<i", data)[0] for servo, data in (self.answer() for _ in servos)}


def steps(angle):
    return 2048 + round(angle * 4096 / (2 * math.pi))


def angle(value):
    return (value - 2048) * 2 * math.pi / 4096


def main():
    bus = Bus(sys.argv[1])
    for servo in GOALS:
        bus.send(servo, PING)
        number, firmware = struct.unpack("<HB", bus.answer()[1])
        print(f"servo {servo}: model {number}, firmware {firmware}")
        bus.send(servo, WRITE, struct.pack("<HB", TORQUE_ENABLE, 1))
        bus.answer()
    bus.sync_write(PROFILE_VELOCITY, {servo: 50 for servo in GOALS})  # 50 * 0.229 rev/min: 1.2 rad/s
    bus.sync_write(GOAL_POSITION, {servo: steps(goal) for servo, goal in GOALS.items()})
    end = time.monotonic() + 20
    while time.monotonic() < end:
        seen = {servo: angle(value) for servo, value in bus.sync_read(PRESENT_POSITION, list(GOALS)).items()}
        if all(abs(seen[servo] - goal) < 0.04 for servo, goal in GOALS.items()):
            break
        time.sleep(0.02)
    bus.send(BOARD, READ, struct.pack("<HH", 48, 12))
    force = struct.unpack("<fff", bus.answer()[1])
    print(f"shoulder {seen[SHOULDER]:.3f} rad, elbow {seen[ELBOW]:.3f} rad, accelerometer "
          f"{force[0]:.2f} {force[1]:.2f} {force[2]:.2f} m/s^2")
    return 0 if time.monotonic() < end else 1


if __name__ == "__main__":
    sys.exit(main())
