# A filter of headers for doxygen. The first comment, in //, becomes the description of the file. A comment behind several
# variables is each one's. Comparisons of all members need none. Lines keep their numbers.
FNR == 1 { first = 1 }
first && /^\/\/ / { sub(/^\/\//, "///"); held = held ? held "\n" $0 : $0; next }
first { if (held) print held " @file"; first = 0 }
/operator==.*= default;/ { print ""; next }
# "type a = 0, b = 0;  ///< comment"
match($0, /^ *([a-z]+ )*(std::)?[A-Za-z0-9_]+ [A-Za-z_0-9]+( = [^,;({]+)?(, [A-Za-z_0-9]+( = [^,;({]+)?)+; *\/\/\/</) {
  comment = substr($0, RSTART + RLENGTH)
  declared = substr($0, 1, RLENGTH)
  sub(/; *\/\/\/<$/, "", declared)
  count = split(declared, variable, /, /)
  name = variable[1]
  sub(/ = .*/, "", name)
  type = name
  sub(/[A-Za-z_0-9]+$/, "", type)
  line = variable[1] "; /**<" comment " */"
  for (i = 2; i <= count; ++i) line = line " " type variable[i] "; /**<" comment " */"
  print line
  next
}
{ print }
