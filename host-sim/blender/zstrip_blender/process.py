# Runs the command zstrip as a process of its own, which can be cancelled and tells how far it is. Without bpy.
import os
import signal
import subprocess
import threading
import time
from dataclasses import dataclass

# More of a stream is not kept: reports are some kilobytes.
MAX_OUTPUT = 16 << 20
# A process that was asked to end gets so many seconds before it is killed.
PATIENCE = 2.0


@dataclass(frozen=True)
class Outcome:
    """How a process ended. `status`: its exit status, None if it was cancelled, 127 if it did not start."""

    status: object
    out: str
    err: str

    @property
    def cancelled(self):
        return self.status is None


class Process:
    """A running command. Its streams are read by threads, so that it never waits for a reader."""

    def __init__(self, words, environment=None):
        """Starts the command. One that cannot be started is one that has ended with status 127 and the reason."""
        self.words = list(words)
        self.started = time.monotonic()
        self._cancelled = threading.Event()
        self._lock = threading.Lock()
        self._line = ''
        self._streams = {'out': [], 'err': []}
        self._failure = None
        self._process = None
        self._readers = []
        options = {'start_new_session': True} if os.name == 'posix' else {}
        try:
            self._process = subprocess.Popen(
                self.words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                env=environment, **options)
        except (OSError, ValueError) as error:
            self._failure = f'cannot run {self.words[0]}: {error}'
            return
        for name in ('out', 'err'):
            stream = self._process.stdout if name == 'out' else self._process.stderr
            reader = threading.Thread(target=self._read, args=(name, stream), daemon=True)
            reader.start()
            self._readers.append(reader)

    def _read(self, name, stream):
        size = 0
        with stream:
            for line in stream:
                size += len(line)
                if size > MAX_OUTPUT:
                    continue  # read on, so that the process is not stopped by a full pipe
                text = line.decode('utf-8', 'replace')
                with self._lock:
                    self._streams[name].append(text)
                    if name == 'err' and text.strip():
                        self._line = text.strip()

    @property
    def progress(self):
        """The last line on standard error: what the command does, or complains of; empty so far."""
        with self._lock:
            return self._line

    @property
    def seconds(self):
        """Since the start."""
        return time.monotonic() - self.started

    @property
    def running(self):
        """Also while a process that the command has left behind may still write."""
        return self._process is not None and (
            self._process.poll() is None or any(reader.is_alive() for reader in self._readers))

    def cancel(self):
        """Ends the process, and those that it started, soon. Returns at once."""
        if self._cancelled.is_set() or not self.running:
            return
        self._cancelled.set()
        self._signal(signal.SIGTERM)
        threading.Thread(target=self._kill_later, daemon=True).start()

    def _kill_later(self):
        deadline = time.monotonic() + PATIENCE
        while self.running:
            if time.monotonic() >= deadline:
                self._signal(getattr(signal, 'SIGKILL', signal.SIGTERM))
                return
            time.sleep(0.01)

    def _signal(self, number):
        try:
            if os.name == 'posix':
                os.killpg(self._process.pid, number)
            else:
                self._process.terminate()
        except (ProcessLookupError, PermissionError):
            pass  # it has ended

    def wait(self, asked_to_stop=lambda: False, tell=lambda line: None, interval=0.05):
        """Waits for the end and returns the Outcome. Each `interval` seconds it calls tell(progress), and cancels the
        process once asked_to_stop() is true."""
        while self.running:
            if asked_to_stop():
                self.cancel()
            tell(self.progress)
            time.sleep(interval)
        return self.outcome()

    def outcome(self):
        """The Outcome of a process that has ended."""
        if self._process is None:
            return Outcome(127, '', self._failure)
        for reader in self._readers:
            reader.join()
        status = self._process.wait()
        return Outcome(None if self._cancelled.is_set() else status, ''.join(self._streams['out']),
                       ''.join(self._streams['err']))


def run(words, seconds):
    """Runs a command that ends soon; after `seconds` it is cancelled. Returns its Outcome."""
    process = Process(words)
    return process.wait(asked_to_stop=lambda: process.seconds > seconds, interval=0.005)
