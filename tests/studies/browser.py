"""A page as headless Chromium sees it: its document after scripts have run, what it logged, and what a check found."""

import json
import re
import shutil
import subprocess
from html import unescape
from typing import Any

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
CHECK = """<script>
addEventListener("error", (event) => (window.errors = [...(window.errors || []), String(event.message)]), true);
addEventListener("load", () => {
  const found = (() => { %s })();
  const said = document.createElement("pre");
  said.id = "found";
  said.textContent = JSON.stringify({ found, errors: window.errors || [] });
  document.body.append(said);
});
</script>"""


def open_page(page: str, folder, check: str = "return null", width: int = 1200) -> dict[str, Any]:
    """What `check`, the body of a function in the page, returns once it has loaded; errors; log; the document.

    Skips the test where there is no Chromium.
    """
    program = next(filter(None, map(shutil.which, NAMES)), None)
    if program is None:
        pytest.skip(f"no Chromium on this machine to open the page in ({', '.join(NAMES)})")
    file = folder / "checked.html"
    file.write_text(page.replace("<head>", f"<head>{CHECK % check}", 1), encoding="utf-8")
    ended = subprocess.run(
        [
            program, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
            "--enable-logging=stderr", f"--user-data-dir={folder / 'profile'}", f"--window-size={width},900",
            "--virtual-time-budget=4000", "--dump-dom", file.as_uri(),
        ],
        capture_output=True, text=True, timeout=120, check=True,
    )  # fmt: skip
    found = re.search(r'<pre id="found">(.*?)</pre>', ended.stdout, re.S)
    assert found, "the page's load never ended"
    log = [line for line in ended.stderr.splitlines() if "CONSOLE" in line]
    return json.loads(unescape(found[1])) | {"log": log, "document": ended.stdout}
