#!/usr/bin/env bash
# blender.sh ZSTRIP SCRIPT [--window]: runs a script in Blender, with preferences of its own, and gives it the zip of the
# add-on, the command and an empty folder. --window: with Blender's window, on a display of Xvfb, drawn in software.
# Exit status 77 if Blender, or what it needs, is not installed.
set -euo pipefail
zstrip=$(readlink -f "$1") script=$2

missing() {
  echo "$1 is not installed: apt-get install --no-install-recommends $2"
  exit 77
}
command -v blender >/dev/null || missing Blender "blender python3-numpy"
start=(blender --background)
if [ "${3-}" = --window ]; then
  command -v xvfb-run >/dev/null || missing Xvfb xvfb
  export LIBGL_ALWAYS_SOFTWARE=1
  start=(xvfb-run --auto-servernum --server-args "-screen 0 1280x800x24" blender --window-geometry 0 0 1280 800)
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch"/{home,files}
export HOME=$scratch/home XDG_CONFIG_HOME=$scratch/home/.config XDG_CACHE_HOME=$scratch/home/.cache TMPDIR=$scratch
export PYTHONDONTWRITEBYTECODE=1
# Debian's exporter of glTF needs numpy, which its package does not.
if ! blender --background --factory-startup --python-exit-code 9 --python-expr 'import numpy' >/dev/null 2>&1; then
  missing "numpy of Blender's Python" python3-numpy
fi
"$zstrip" blender -o "$scratch/zstrip_blender.zip" --quiet
"${start[@]}" --factory-startup --python-exit-code 1 --python "$script" \
  -- "$scratch/zstrip_blender.zip" "$zstrip" "$scratch/files"
