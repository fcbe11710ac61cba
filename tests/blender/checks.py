# The scripts in Blender share the arguments of blender.sh, files of the folder of the test, and checks.
import os
import sys

ZIP, ZSTRIP, FOLDER = sys.argv[sys.argv.index('--') + 1:]
failures = []


def path(name):
    return os.path.join(FOLDER, name)


def check(what, said):
    print(('ok      ' if what else 'FAILED  ') + said, flush=True)
    if not what:
        failures.append(said)
