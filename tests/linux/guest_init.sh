#!/bin/busybox sh
# The first program of the guest: loads the modules that the kernel's command line names (zstrip.modules=A,B), then runs
# commands from the console. After each a line "status N" follows.
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
console=$(sed -n 's/.*zstrip.console=\([^ ]*\).*/\1/p' /proc/cmdline)
exec </dev/"$console" >/dev/"$console" 2>&1
stty -echo
for module in $(sed -n 's/.*zstrip.modules=\([^ ]*\).*/\1/p' /proc/cmdline | tr , ' '); do
  while read -r file; do
    # Some are shared, and loaded already.
    lsmod | grep -q "^$(basename "$file" .ko | tr - _) " || insmod "/modules/$file" || echo "cannot load $file"
  done <"/modules/$module"
done

# shows COMMAND...: starts zstrip-panel in the background and returns when it shows its last frame.
shows() {
  zstrip-panel "$@" --hold >/tmp/shown 2>&1 &
  shown=$!
  until grep -q ' frames of ' /tmp/shown; do
    kill -0 $shown 2>/dev/null || break
    usleep 20000
  done
  cat /tmp/shown
}
# ends SIGNAL: stops it; its exit status.
ends() {
  kill -"$1" $shown
  wait $shown
}

echo ready
while read -r line; do
  eval "$line"
  echo "status $?"
done
