#!/usr/bin/env python3
"""Reads and writes registers by pymodbus as it is asked: lines "read ADDRESS COUNT" and "write ADDRESS VALUE ..." on standard
input, each answered by a line "ok VALUE ..." or by what went wrong.

Usage: pymodbus_client.py PORT
"""
import sys

from pymodbus.client import ModbusTcpClient

client = ModbusTcpClient("127.0.0.1", port=int(sys.argv[1]), timeout=60)
client.connect()
for line in sys.stdin:
    words = line.split()
    numbers = [int(word) for word in words[1:]]
    if words[0] == "read":
        answer = client.read_input_registers(numbers[0], numbers[1], slave=1)
    else:
        answer = client.write_registers(numbers[0], numbers[1:], slave=1)
    registers = getattr(answer, "registers", None) or []
    print(str(answer) if answer.isError() else "ok " + " ".join(map(str, registers)), flush=True)
