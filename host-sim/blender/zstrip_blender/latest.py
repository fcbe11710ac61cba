# Draws the newest state of something that changes, by one process at a time. Without bpy.
import time

# A picture that is nearly drawn is finished first: one that plays would else never be seen.
FINISH_SECONDS = 1.0


class Latest:
    """Starts a process for the newest request, and keeps the newest result."""

    def __init__(self, start, finish, clock=time.monotonic):
        """`start(request)` returns a process.Process, or raises; `finish(request, outcome)` gets its Outcome, unless it
        was cancelled. `clock` returns seconds."""
        self._start, self._finish, self.clock = start, finish, clock
        self._request = self._running = self._process = None
        self._since = 0.0
        self._closed = False

    @property
    def idle(self):
        """Nothing runs and nothing waits."""
        return self._process is None and self._request is None

    def ask(self, request):
        """Draws this instead of what waits."""
        if not self._closed:
            self._request = request

    def step(self):
        """Goes on as far as is possible without waiting. To be called again and again until idle."""
        if self._process is not None:
            if self._process.running:
                if self._request is not None and self.clock() - self._since > FINISH_SECONDS:
                    self._process.cancel()
                return
            process, self._process = self._process, None
            outcome = process.outcome()
            if not outcome.cancelled and not self._closed:
                self._finish(self._running, outcome)
        if self._request is not None and not self._closed:
            self._running, self._request = self._request, None
            self._since = self.clock()
            self._process = self._start(self._running)

    def close(self):
        """Cancels what runs and forgets what waits."""
        self._closed = True
        self._request = None
        if self._process is not None:
            self._process.cancel()
