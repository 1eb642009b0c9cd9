#!/usr/bin/env python3
"""An agent of RCSSServerMJ, written from the description of its messages alone (docs/agent_server.md).

plain_agent.py PORT MODEL TEAM NUMBER

Beams to 1.5 m behind the middle line, robot 1 at y = -0.5 m, 2 at 0, 3 at 0.5 m. Reads a message a cycle until the server closes, asks each motor for the angle at
which it stands, and prints as JSON what it has been told. Ends with 1 where a message lacks what clients rely on.
"""

import json
import re
import socket
import struct
import sys
import time

KEYS = ["time.now", "GS.t", "GS.pm", "GS.tl", "GS.sl", "GS.sr", "quat.n", "quat.q", "pos.p", "GYR.rt", "ACC.a"]


def connected(port):
    for _ in range(600):
        try:
            return socket.create_connection(("127.0.0.1", port))
        except OSError:
            time.sleep(0.05)
    sys.exit(f"nobody listens on port {port}")


def send(connection, text):
    connection.sendall(struct.pack(">I", len(text)) + text.encode("ascii"))


def exactly(connection, size):
    data = b""
    while len(data) < size:
        piece = connection.recv(size - len(data))
        if not piece:
            return None
        data += piece
    return data


def receive(connection):
    try:
        head = exactly(connection, 4)
        data = None if head is None else exactly(connection, struct.unpack(">I", head)[0])
    except ConnectionResetError:
        return None
    return None if data is None else data.decode("ascii")


def groups(text):
    """{"GS": {"t": [...], ...}, ...}, and joints' (name, angle) in their order: as clients' parsers do, without nesting."""
    found, joints = {}, []
    for name, body in re.findall(r"\((\w+) ((?:\([^()]*\)\s*)+)\)", text):
        values = {w[0]: w[1:] for w in (group.split() for group in re.findall(r"\(([^()]*)\)", body)) if w}
        if name == "HJ":
            joints.append((values["n"][0], float(values["ax"][0])))
        found[name] = values
    return found, joints


def main():
    port, model, team, number = int(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4]
    connection = connected(port)
    send(connection, f"(init {model} {team} {number})")
    send(connection, f"(beam 1.5 {0.5 * int(number) - 1} 0)(syn)")
    told = {"cycles": 0, "missing": [], "joints": [], "modes": [], "sees": 0}
    last = -1.0
    while (text := receive(connection)) is not None:
        if text.startswith("(error"):
            sys.exit(text)
        found, joints = groups(text)
        told["missing"] += [key for key in KEYS if key.split(".")[1] not in found.get(key.split(".")[0], {})]
        now = float(found["time"]["now"][0])
        if now <= last:
            told["missing"].append("a time that grows")
        last = now
        told["cycles"] += 1
        told["joints"] = [name for name, _ in joints]
        told["pos"] = [float(v) for v in found.get("pos", {}).get("p", [])]
        told["quat"] = [float(v) for v in found.get("quat", {}).get("q", [])]
        told["sees"] += "(See" in text
        if found["GS"]["pm"][0] not in told["modes"]:
            told["modes"].append(found["GS"]["pm"][0])
        send(connection, "".join(f"({name[2:]} {angle} 0.0 50 1 0.0)" for name, angle in joints) + "(syn)")
    told["now"] = last
    print(json.dumps(told))
    return 1 if told["missing"] else 0


if __name__ == "__main__":
    sys.exit(main())
