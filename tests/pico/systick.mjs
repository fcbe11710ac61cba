// SysTick as Armv6-M has it (B3.3): it counts from the reload value down to 0, and only the step from 1 to 0 is a
// tick. The emulator's own ticks at once when it is enabled.
const kControl = 0x10, kReload = 0x14, kCurrent = 0x18;
const kEnable = 1, kInterrupt = 2, kProcessorClock = 4, kCounted = 1 << 16;

/** Takes the registers' place in `emulator`. */
export function replaceSystick(emulator, complain) {
  const {ppb, core, clock} = emulator;
  let control = 0, reload = 0, counted = 0;
  let value = 0, since = 0;  // what it was, and when
  const cycles = () => Math.floor((clock.nanos - since) * emulator.clkSys / 1e9 + 1e-6);
  const alarm = clock.createAlarm(() => {
    counted = kCounted;
    if (control & kInterrupt) core.pendingSystick = core.interruptsUpdated = true;
    startAt(reload + 1);
  });
  function startAt(count) {
    [value, since] = [count, clock.nanos];
    if (control & kEnable && reload > 0) alarm.schedule(count * 1e9 / emulator.clkSys);
  }
  const read = ppb.readUint32.bind(ppb), write = ppb.writeUint32.bind(ppb);
  ppb.systickTimer.enable = false;
  ppb.readUint32 = (offset) => {
    if (offset === kReload) return reload;
    if (offset === kCurrent) return (control & kEnable ? value - cycles() : value) % (reload + 1);
    if (offset !== kControl) return read(offset);
    const result = control | counted;
    counted = 0;
    return result;
  };
  ppb.writeUint32 = (offset, word) => {
    if (offset === kReload) {
      reload = word & 0xffffff;
    } else if (offset === kCurrent) {
      counted = 0;
      alarm.cancel();
      startAt(reload + 1);
    } else if (offset === kControl) {
      const left = control & kEnable ? value - cycles() : value;
      alarm.cancel();
      control = word & 7;
      if (control & kEnable && !(control & kProcessorClock)) complain('systick: its reference clock is none here');
      startAt(left > 0 ? left : reload + 1);
    } else {
      write(offset, word);
    }
  };
}
