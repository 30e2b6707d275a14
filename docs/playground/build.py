"""Puts the playground into the documentation that Sphinx has built: an extension of docs/conf.py.

The folder `playground` of the site has the page, Pyodide (Python for browsers) and Vega from npm, by package-lock.json;
in python.zip the modules of Python, ev3proto and the packages that it needs, as they are installed here; and in
snapshot.bin the memory of a Python that has imported them.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from ev3proto.generate.exported import EXPORTED
from ev3proto.generate.javascript import decoder
from ev3proto.version import VERSION

from .packing import PACKAGES, pack

HERE = Path(__file__).parent
CAPTURES = HERE.parents[1] / "captures"
LESSON = CAPTURES / "lesson-02.log"
CONFORMANCE = CAPTURES / "conformance.pcapng"
READ = tuple(CAPTURES / f"{name}.pcapng" for name in ("wifi", "usb", "bluetooth"))
"""Captures that are read before the snapshot is taken."""
WITHOUT = "no_playground"
"""The tag with which Sphinx builds everything except the playground."""

DECODER = (decoder.DECODER_NAME, decoder.TEXTS_NAME)
"""What shows the first frame without Python."""
APART = "timeline.js"
"""A script that is loaded when it is used, with Vega."""
PAGE = ("*.html", "*.css", "missing.js", APART)
SERVICE_WORKER = "service-worker.js"
BRICK = ("brick.css", "icon.svg")
BRICK_SCRIPT = "brick.js"
JOINED = ("playground.js", "worker.js")
"""Scripts that are each joined with what they import: the first frame then waits for a few files, not for forty."""
PYODIDE = ("pyodide.mjs", "pyodide.asm.js", "pyodide.asm.wasm")
SNAPSHOTS = ("snapshot.bin", "snapshot_brotli.bin")
LARGE = ("python.zip", *SNAPSHOTS, *(f"pyodide/{name}" for name in PYODIDE))
"""Files whose size the page says while they are loaded."""
VEGA = ("vega/build/vega.min.js", "vega-lite/build/vega-lite.min.js", "vega-interpreter/build/vega-interpreter.js")
LICENCES = "spdx-license-list"
PYTHON_LICENCE = "Python-2.0.1"
RULE = "-" * 80


def setup(app: Sphinx) -> dict[str, Any]:
    """Registers the step that runs when the pages are built."""
    app.connect("builder-inited", _begun)
    app.connect("build-finished", _finished)
    return {"parallel_read_safe": True}


def _is_wanted(app: Sphinx) -> bool:
    return app.builder.format == "html" and not app.tags.has(WITHOUT)


def _begun(app: Sphinx) -> None:
    if _is_wanted(app) and shutil.which("npm") is None:
        raise ExtensionError(f"npm is not installed, which the playground needs; -t {WITHOUT} builds the rest")


def _finished(app: Sphinx, error: Exception | None) -> None:
    if error is None and _is_wanted(app):
        build(Path(app.outdir) / "playground", Path(app.outdir).parent / "npm")


def build(site: Path, npm: Path) -> None:
    """Builds the playground.

    Args:
        site: The output folder.
        npm: A folder in which npm may install packages.

    Raises:
        ExtensionError: npm cannot install them.
    """
    modules = _installed(npm)
    for name in ("pyodide", "vega"):
        (site / name).mkdir(parents=True, exist_ok=True)
    brick = files("ev3proto.brick.servers.page") / "static"
    for name in BRICK:
        (site / name).write_bytes((brick / name).read_bytes())
    for name in PYODIDE:
        shutil.copy(modules / "pyodide" / name, site / "pyodide" / name)
    for name in VEGA:
        text = (modules / name).read_text(encoding="utf-8")
        # vega.min.js already contains what this module imports. The source maps are not part of the site.
        text = re.sub(
            r"^import \{(.*)\} from 'vega-util';$", r"const {\1} = globalThis.vega;", text, flags=re.MULTILINE
        )
        text = re.sub(r"^//# sourceMappingURL=.*$", "", text, flags=re.MULTILINE)
        (site / "vega" / Path(name).name).write_text(text, encoding="utf-8")
    (site / "lesson.json").write_text(json.dumps(list(_lesson()), indent=1), encoding="utf-8")
    shutil.copy(CONFORMANCE, site / CONFORMANCE.name)
    pack(site / "python.zip", modules / "pyodide" / "python_stdlib.zip")
    _make_snapshot(modules / "pyodide", site)
    for file in sorted(file for kind in PAGE for file in HERE.glob(kind)):
        text = file.read_text(encoding="utf-8").replace("@VERSION@", VERSION)
        (site / file.name).write_text(text, encoding="utf-8")
    scripts = {name: EXPORTED[name]() for name in DECODER}
    scripts |= {file.name: file.read_text(encoding="utf-8") for file in HERE.glob("*.js")}
    scripts[BRICK_SCRIPT] = (brick / BRICK_SCRIPT).read_text(encoding="utf-8")
    sizes = json.dumps({name: (site / name).stat().st_size for name in LARGE})
    scripts["boot.js"] = scripts["boot.js"].replace("/* @SIZES@ */ {}", sizes)
    _join(modules, scripts, site)
    (site / "licences.txt").write_text("\n".join([*_licences(modules), ""]), encoding="utf-8")
    _name_files(site)


def _join(modules: Path, scripts: dict[str, str], site: Path) -> None:
    """Joins the scripts of the page, and those of its worker."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in scripts.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        command = [shutil.which("node") or "node", str(modules / "esbuild-wasm" / "bin" / "esbuild"), *JOINED]
        command += ["--bundle", "--minify", "--format=esm", "--log-level=warning"]
        command += [f"--external:./{APART}", f"--outdir={site}"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode or done.stderr:
        raise ExtensionError(f"the scripts of the playground cannot be joined: {done.stderr.strip()[:600]}")


def _make_snapshot(pyodide: Path, site: Path) -> None:
    """Has Python start in node, and keeps its memory."""
    command = [shutil.which("node") or "node", str(HERE / "make_snapshot.mjs"), str(pyodide)]
    command += [str(site / "python.zip"), *(str(site / name) for name in SNAPSHOTS), *map(str, READ)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        said = " ".join(done.stderr.split())[-600:]
        raise ExtensionError(f"the snapshot of Python cannot be made: {said}")


def _name_files(site: Path) -> None:
    """Tells the service worker the files of the site, each with its digest."""
    worker = site / SERVICE_WORKER
    worker.unlink(missing_ok=True)
    files_of_site = sorted(file for file in site.rglob("*") if file.is_file())
    digests = {
        file.relative_to(site).as_posix(): hashlib.sha256(file.read_bytes()).hexdigest() for file in files_of_site
    }
    version = hashlib.sha256(json.dumps(digests).encode()).hexdigest()[:16]
    text = (HERE / SERVICE_WORKER).read_text(encoding="utf-8")
    text = text.replace("@FILES_VERSION@", version).replace("@FILES@", json.dumps(digests, indent=1))
    worker.write_text(text, encoding="utf-8")


def _installed(npm: Path) -> Path:
    """Returns the folder of the installed packages."""
    npm.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(HERE / name, npm / name)
    command = [shutil.which("npm") or "npm", "ci", "--omit=dev", "--ignore-scripts", "--no-audit", "--no-fund"]
    done = subprocess.run(command, cwd=npm, capture_output=True, text=True, check=False)
    if done.returncode:
        said = " ".join(done.stderr.split())[:300]
        raise ExtensionError(f"npm cannot install what the playground needs ({said}): -t {WITHOUT} builds the rest")
    return npm / "node_modules"


def _lesson() -> Iterator[dict[str, str]]:
    """The commands of the lesson, each with its title."""
    title = ""
    seen: dict[str, int] = {}
    for line in LESSON.read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            title = line.removeprefix("#").strip()
            continue
        _, is_sent, frame = line.partition("Sent ")
        if is_sent:
            number = seen[title] = seen.get(title, 0) + 1
            yield {"title": title if number == 1 else f"{title}: {number}", "frame": frame}


def _licences(modules: Path) -> Iterator[str]:
    """The third-party parts of the site, each with the licence in its package."""
    yield "Works of others that are in the playground, or come with the packages it is built from, and their licences."
    named: dict[str, list[str]] = {}
    for title, text in (*_npm_licences(modules), *_python_licences()):
        named.setdefault(text, []).append(title)
    for text, titles in named.items():
        yield from ("", RULE, *titles, RULE, "", text)


def _npm_licences(modules: Path) -> Iterator[tuple[str, str]]:
    """Each npm package with its licence. Vega's builds contain most packages that came with it."""
    known = modules / LICENCES
    for file in sorted(modules.rglob("package.json")):
        about = json.loads(file.read_text(encoding="utf-8"))
        if "version" not in about or file.parent == known or not _is_package(file):
            continue
        found = sorted(each for each in file.parent.iterdir() if re.match(r"(?i)licen[cs]e", each.name))
        text = found[0].read_text(encoding="utf-8") if found else _known_licence(known, about["license"])
        source = about["repository"]["url"] if isinstance(about["repository"], dict) else about["repository"]
        yield f"{about['name']} {about['version']}, {about['license']}, source: {source}", text.strip()
        if about["name"] == "pyodide":
            python = json.loads((file.parent / "pyodide-lock.json").read_text(encoding="utf-8"))["info"]["python"]
            title = f"Python {python}, a part of pyodide, source: https://www.python.org/downloads/source/"
            yield title, _known_licence(known, PYTHON_LICENCE).strip()


def _is_package(file: Path) -> bool:
    """Returns whether a file describes a package, not a part of one."""
    parent = file.parent.parent
    return parent.name == "node_modules" or (parent.name.startswith("@") and parent.parent.name == "node_modules")


def _known_licence(known: Path, name: str) -> str:
    """Returns the text of a licence by its SPDX name, for packages without a licence file."""
    text: str = json.loads((known / "licenses" / f"{name}.json").read_text(encoding="utf-8"))["licenseText"]
    return text


def _python_licences() -> Iterator[tuple[str, str]]:
    for package in PACKAGES:
        found = importlib.metadata.distribution(package)
        texts = [each for each in found.files or () if re.match(r"(?i)licen[cs]e", each.name) and "info" in str(each)]
        yield f"{found.name} {found.version}", "\n\n".join(each.read_text().strip() for each in texts)
    yield f"ev3proto {VERSION}", (HERE.parents[1] / "LICENSE").read_text(encoding="utf-8").strip()
