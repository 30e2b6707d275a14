"""The Python side of the playground, without a browser."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from support.effort import effort
from support.frames import drawn
from support.scripts import PLAYGROUND

from ev3proto.testing import frames, mutated_frames

ROOT = Path(__file__).parents[2]

AFTER_THE_SNAPSHOT = """\
import json, sys
import bridge
warm_up, texts = json.load(sys.stdin)
for call, *given in warm_up:
    getattr(bridge, call)(*given)
known = set(sys.modules)
for text in texts:
    bridge.look(text)
    bridge.to_send()
    new = set(sys.modules) - known
    assert not new, (text, new)
"""


def test_the_snapshot_has_every_module_that_reading_needs(tmp_path: Path) -> None:
    """Modules that are not in the snapshot come later, in python.zip."""
    (tmp_path / "boot.mjs").write_text((PLAYGROUND / "boot.js").read_text(encoding="utf-8"), encoding="utf-8")
    script = "import { WARM_UP } from './boot.mjs'; console.log(JSON.stringify(WARM_UP))"
    command = ["node", "--input-type=module", "--eval", script]
    warm_up = json.loads(subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True).stdout)
    texts = [
        "0x|08:00|2A:00|00|04:00|81:01:60|\n0x|07:00|2A:00|02|66:66:F6:40|",
        "0x|0B:00|2A:00|80|00:00|94:02:01:84:1B:00|",  # an escape, which is shown as \u001b
        "OUTPUT_POWR(0, 1, 50)",
        "Hello!",
        "vmthread MAIN\n{\n  UI_WRIT(LED, 1)\n}\n",
        *[each.hex() for strategy in (frames(), mutated_frames()) for each in drawn(strategy, effort(100, 2000))],
    ]
    environment = {**os.environ, "PYTHONPATH": str(PLAYGROUND)}
    done = subprocess.run(
        [sys.executable, "-c", AFTER_THE_SNAPSHOT],
        env=environment,
        input=json.dumps([warm_up, texts]),
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
