"""The packages that data come from, each pinned by version and by the sha256 of its archive (`packages.json`)."""

import hashlib
import json
import subprocess
import tarfile
from dataclasses import dataclass
from pathlib import Path

from .errors import DataError

MANIFEST = Path(__file__).with_name("packages.json")


@dataclass(frozen=True)
class Package:
    """One npm package. `use` is `train` or `test`; a package for tests is never trained on."""

    name: str
    version: str
    sha256: str
    licence: str
    use: str
    holds: str

    @property
    def folder(self) -> str:
        return self.name.replace("@", "").replace("/", "-")


def listed() -> dict[str, Package]:
    """All of the manifest, by name."""
    return {entry["name"]: Package(**entry) for entry in json.loads(MANIFEST.read_text(encoding="utf-8"))}


def fetch(package: Package, into: Path) -> Path:
    """The unpacked package under `into`; downloaded with npm unless its archive is there already.

    Raises DataError if npm cannot get it or the archive is not the pinned one.
    """
    into.mkdir(parents=True, exist_ok=True)
    archive = into / f"{package.folder}-{package.version}.tgz"
    if not archive.exists():
        wanted = f"{package.name}@{package.version}"
        done = subprocess.run(["npm", "pack", "--silent", wanted], cwd=into, capture_output=True, text=True, check=False)
        if done.returncode or not archive.exists():
            raise DataError(f"npm cannot get {wanted}: {done.stderr.strip()[:300] or 'no archive came'}")
    found = hashlib.sha256(archive.read_bytes()).hexdigest()
    if found != package.sha256:
        raise DataError(f"{archive.name} has sha256 {found} and {MANIFEST.name} says {package.sha256}. Delete it and fetch again.")
    folder = into / f"{package.folder}-{package.version}"
    if not folder.exists():
        part = folder.with_suffix(".part")
        with tarfile.open(archive) as tar:
            tar.extractall(part, filter="data")
        (part / "package").rename(folder)
    return folder
