"""Messages of the command line about wrong use or wrong input: what is wrong first, then what would be right."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.cli import ROOT
from support.cli import run_ev3proto_text as run

CAPTURE = str(ROOT / "captures/wifi.pcapng")
TONE = "SOUND(TONE, 1, 440, 1000)"
FRAME = "06:00|2A:00|80|00:00|01"

OF_THE_CALL = {
    "dcode": "No such command 'dcode'. Did you mean 'decode'?",
    "export pcap": "No such command 'pcap'. Did you mean 'pcapng'?",
    "dissector instal": "No such command 'instal'. Did you mean 'install'?",
    "nonsense": "No such command 'nonsense'.",
    "help dcode": "No such command 'dcode'. Did you mean 'decode'?",
    "help export pcap": "No such command 'pcap'. Did you mean 'pcapng'?",
    "help decode foo": "ev3proto decode has no subcommands",
    "check --explain E999": "Invalid value for '--explain': unknown code E999: did you mean E806?",
    "check --explain E10100": "Invalid value for '--explain': unknown code E10100: did you mean E101?",
    "send nowhere 01": "Invalid value for 'TARGET': unknown target 'nowhere'; expected wifi, wifi:ADDRESS,"
    " wifi:ADDRESS:PORT, usb, usb:SERIALNUMBER, bluetooth:MAC, serial:PORT or virtual",
    "send wfi 01": "Invalid value for 'TARGET': unknown target 'wfi': did you mean wifi?",
    "send bluetooth 01": "Invalid value for 'TARGET': 'bluetooth' does not name a brick; expected its address, such as"
    " bluetooth:00:16:53:42:2B:99",
    "send wifi:192.0.2.1:99999 01": "Invalid value for 'TARGET': invalid port 99999 in 'wifi:192.0.2.1:99999'; expected"
    " 1 to 65535",
    "send wifi:192.0.2.1:x 01": "Invalid value for 'TARGET': invalid port in 'wifi:192.0.2.1:x'; expected a number,"
    " such as 5555",
    "send virtual --timeout nan 01": "Invalid value for '--timeout': nan is not a finite number",
    "send virtual --timeout x 01": "Invalid value for '--timeout': 'x' is not a valid number.",
    "decode --port x 00": "Invalid value for '--port': 'x' is not a valid integer.",
    "encode --version 99999 x": "Invalid value for '--version': invalid version 99999; expected a whole number from 0"
    " to 65535, such as 0x6D",
    "encode --to rbf --counter 3 x": "--counter and --to rbf or -o FILE.rbf cannot be used together",
    "encode -o x.rbf --no-reply --filter op==NOP x": "--no-reply, --filter and --to rbf or -o FILE.rbf cannot be used"
    " together",
    "encode --shortest --to hex x": "--source, --version and --shortest are for programs; add --to rbf or -o FILE.rbf",
    "decode --all --engine wireshark 00": "--all and --engine wireshark cannot be used together",
    "decode --no-length --operations 00": "--no-length and --operations cannot be used together",
    "decode --json --format asm 00": "--json and --format asm cannot be used together",
    "decode --dialogues --programs 00": "--dialogues and --programs cannot be used together",
    "decode --dialogues --format asm 00": "--dialogues and --format asm cannot be used together",
    "decode --format xml 00": "Invalid value for '--format': 'xml' is not one of 'tree', 'table', 'sentence', 'asm',"
    " 'lego', 'json', 'csv', 'listing'.",
    "check --filter op==NOP SOUND(BREAK)": "--filter is for frames, but SOUND(BREAK) has none yet",
    "encode --filter op==NOP SOUND(BREAK)": "--filter is for frames, but SOUND(BREAK) has none yet",
    "check --strict --errors-only 00": "--strict and --errors-only cannot be used together",
    "check --json --format github 00": "--json and --format github cannot be used together",
    "check --quiet --format sarif 00": "--quiet and --format sarif cannot be used together",
    "check --fix --format sarif 00": "--fix and --format sarif cannot be used together",
    "check --explain E101 00": "--explain and FRAME cannot be used together",
    "check --explain E101 --strict --carrier usb": "--explain and --strict, --carrier cannot be used together",
    "check --explain E101 --fix --format sarif": "--explain and --fix, --format sarif cannot be used together",
    "values --csv --json x": "--csv and --json cannot be used together",
    "values --plot no/x.svg --csv x": "--plot and --csv cannot be used together",
    "sample --accepted --mutate": "--accepted and --mutate cannot be used together",
    "run --http --limit 3 x.rbf": "--http and --limit cannot be used together",
    "brick --no-wifi --serial x --beacon": "--no-wifi and --beacon cannot be used together",
    "brick --no-wifi --port 5": "--no-wifi and --port cannot be used together",
    "brick --no-wifi": "--no-wifi needs --serial or --http; otherwise no client can reach the brick",
    "brick --json": "--errors-only and --json need --report",
    "brick --serial-number zz": "Invalid value for '--serial-number': invalid serial number 'zz'; expected 12"
    " hexadecimal digits",
    "proxy --to virtual --record - --json": "--record - and --json cannot be used together: both write to standard"
    " output",
    "proxy --to virtual --listen usb": "Invalid value for '--listen': cannot listen at 'usb'; expected wifi,"
    " wifi:ADDRESS or wifi:ADDRESS:PORT",
    "proxy --to virtual --from home": "Invalid value for '--from': invalid address 'home'; expected one such as"
    " 192.0.2.1",
    "replay x --to virtual --allow engines": "Invalid value for '--allow': unknown operation or group 'engines';"
    " expected an operation, all, or one of motors, files, deletes, settings, programs, messages, buttons, devices,"
    " sounds, display, lights, restarts, firmware, shell, computing, unknown",
    "copy virtual a b": "neither SOURCE nor DESTINATION is on the brick; write its path there as brick:PATH",
    "copy virtual brick:a brick:b": "SOURCE and DESTINATION are both on the brick; one must be a file of this computer",
    "export c-header --check": "--check needs -o",
    "files --force x": "--force needs -o",
}


@pytest.mark.parametrize("words", OF_THE_CALL)
def test_a_wrong_call(words: str) -> None:
    done = run(*words.split())
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.splitlines()[-1] == f"Error: {OF_THE_CALL[words]}"


OF_THE_INPUT = {
    "decode missing.pcap": "missing.pcap: cannot be read: No such file or directory",
    "decode --dialogues missing.pcap": "missing.pcap: cannot be read: No such file or directory",
    "decode --filter op==NOP zz": "'zz' is neither a file nor a frame: 'zz' is not hex",
    "check folder/missing": "folder/missing: cannot be read: No such file or directory",
    "encode missing.lms": "missing.lms: cannot be read: No such file or directory",
    "encode missing.lms -o x.rbf": "missing.lms: cannot be read: No such file or directory",
    "export pcapng missing.log -o x.pcapng": "missing.log: cannot be read: No such file or directory",
    "send virtual missing.log": "missing.log: cannot be read: No such file or directory",
    "stats missing.pcap": "missing.pcap: cannot be read: No such file or directory",
    "decode zz": "'zz' is neither a file nor a frame: 'zz' is not hex",
    "decode 06:00:2A:00:80:00:00:G1": "'06:00:2A:00:80:00:00:G1', column 22: 'G1' is not hex",
    "decode 0600a": "'0600a' has an odd number of hex digits (5); two make a byte",
    f"decode {TONE}": f"'{TONE}' is assembly, not a frame; `ev3proto encode` makes frames of it",
    "encode LIST_FILES@(path='/x')": "\"LIST_FILES@(path='/x')\" is neither a file nor assembly nor a frame:"
    ' "LIST_FILES@(path=\'/x" is not hex',
    "encode foo": "'foo' is neither a file nor assembly nor a frame: 'foo' is not hex",
    "decode hello.txt": f"hello.txt: no frame found; frames are written in hex, such as {FRAME}",
    "decode --dialogues hello.txt": f"hello.txt: no frame found; frames are written in hex, such as {FRAME}",
    "check hello.txt empty.txt": f"empty.txt: no frame found; frames are written in hex, such as {FRAME}",
    "stats hello.txt": f"hello.txt: no frame found; frames are written in hex, such as {FRAME}",
    "decode --programs log.txt": "log.txt: no program in 1 frame",
    "decode tone.lms": "tone.lms: no frame found, but the source of a program; `ev3proto encode -o FILE.rbf` makes its"
    " image",
    "decode tone.asm": "tone.asm: no frame found, but assembly; `ev3proto encode` makes frames of it",
    "encode hello.txt": "hello.txt: nothing to encode; expected assembly such as SOUND(TONE, 1, 440, 1000), objects as"
    f" `decode --json` prints them, or frames in hex such as {FRAME}",
    "encode tone.lms": "tone.lms: this is a program, not a frame; add -o FILE.rbf to make its image",
    "encode short.rbf": "short.rbf: this is a program image (.rbf); `ev3proto decode` shows it",
    "stats short.rbf": "short.rbf: this is a program image (.rbf); `ev3proto decode` shows it",
    f"decode {CAPTURE} --filter FREQUENCY>99999": f"{CAPTURE}: no frame in 58 packets matches the filter",
    f"decode {CAPTURE} --filter latency>10": (
        f"{CAPTURE}: no frame in 58 packets matches the filter; a number without a unit is in seconds: 10ms"
    ),
    f"decode {CAPTURE} --dialogues --filter latency>10": (
        f"{CAPTURE}: no frame in 58 packets matches the filter; a number without a unit is in seconds: 10ms"
    ),
    f"decode {CAPTURE} --filter latency>10s": f"{CAPTURE}: no frame in 58 packets matches the filter",
    f"values {CAPTURE} --filter latency>10": (
        f"{CAPTURE}: no frame in 58 packets matches the filter; a number without a unit is in seconds: 10ms"
    ),
    f"check {CAPTURE} --filter FREQUENCY>99999": f"{CAPTURE}: no command in 58 packets matches the filter",
    "replay hello.txt --to virtual": f"hello.txt: no frame found; frames are written in hex, such as {FRAME}",
    "values log.txt": "log.txt: no reply with its command found",
    "ops FOO": "no operation matches 'FOO'; `ev3proto ops` lists all operations",
    "ops 999": "no operation matches '999'; `ev3proto ops` lists all operations",
    "ops SOUND.TON": "no operation matches 'SOUND.TON': did you mean SOUND.TONE or SOUND?",
    "ops batery": "no operation matches 'batery': did you mean battery?",
    "help E999": "unknown code E999: did you mean E806?",
    "help FOO": "no operation matches 'FOO'; `ev3proto ops` lists all operations",
    "send wifi:127.0.0.1:1 NOP()": "nothing is listening on 127.0.0.1:1; is the brick's WiFi on? `ev3proto brick`"
    " starts a virtual brick",
    "send wifi:no.such.host.invalid NOP()": "cannot find no.such.host.invalid: no computer or brick has this name",
    "send serial:/dev/none NOP()": "no such serial port: /dev/none; pair the brick with this computer first (on Linux,"
    " `rfcomm bind 0 MAC` then creates /dev/rfcomm0)",
    "brick --script port.toml --quiet": "port.toml: ports.9: unknown port 9; expected one of 1, 2, 3, 4, A, B, C, D",
    "brick --script broken.toml --quiet": "broken.toml: invalid TOML: Invalid value (at line 1, column 5)",
    "brick --no-wifi --serial none/ev3 --quiet": "none/ev3: cannot be created: No such file or directory",
    "export c-header -o empty.txt --check": "empty.txt is out of date; run this without --check to write it again",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in {
        "hello.txt": "hello world\n",
        "empty.txt": "",
        "tone.lms": "vmthread MAIN\n{\n  SOUND(TONE, 1, 440, 1000)\n}\nsubcall OTHER\n{\n}\n",
        "tone.asm": f"{TONE}\n",
        "log.txt": "sent 06 00 2a 00 80 00 00 01\n",
        "port.toml": "[ports.9]\ntype = 16\n",
        "broken.toml": "x = = 1\n",
        "short.rbf": "LEGO",
    }.items():
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.parametrize("words", OF_THE_INPUT)
def test_a_wrong_input(words: str, folder: Path) -> None:
    command, _, rest = words.partition(" ")
    done = run(command, *([TONE] if rest == TONE else rest.split()), cwd=folder)
    assert done.returncode == 1
    assert OF_THE_INPUT[words] in done.stderr.splitlines()
