# A filter of headers for doxygen; lines keep their numbers.
#   - The first comment, in //, becomes the description of the file.
#   - Lines of a comment that are indented by five are code, unless they belong to an item of a list.
#   - A comment behind several variables is each one's: "type a = 0, b = 0;  ///< comment".
#   - Comparisons of all members need no comment.
#   - Private members are left out: of a private class doxygen makes a link that leads nowhere.

# A line is printed when the next one is known, because code may end with it.
function put(line) {
  if (line ~ /^ *\/\/\/ *- /) in_list = 1
  else if (line !~ /^ *\/\/\/     /) in_list = 0
  if (!in_list && line ~ /^ *\/\/\/     /) {
    sub(/\/\/\/     /, in_code ? "///  " : "/// @code ", line)
    in_code = 1
  } else if (in_code) {
    held = held " @endcode"
    in_code = 0
  }
  if (holds) print held
  held = line
  holds = 1
}

FNR == 1 { first = 1 }
/^ private:/ { is_private = 1 }
/^ (public|protected):/ || /^};/ { is_private = 0 }
is_private { put(""); next }
first && /^\/\/ / { sub(/^\/\//, "///") }
first && !/^\/\// {
  if (holds) held = held (in_code ? " @endcode" : "") " @file"
  in_code = first = 0
}
/operator==.*= default;/ { put(""); next }
match($0, /^ *([a-z]+ )*(std::)?[A-Za-z0-9_]+ [A-Za-z_0-9]+( = [^,;({]+)?(, [A-Za-z_0-9]+( = [^,;({]+)?)+; *\/\/\/</) {
  comment = substr($0, RSTART + RLENGTH)
  declared = substr($0, 1, RLENGTH)
  sub(/; *\/\/\/<$/, "", declared)
  count = split(declared, variable, /, /)
  type = variable[1]
  sub(/ = .*/, "", type)
  sub(/[A-Za-z_0-9]+$/, "", type)
  line = variable[1] "; /**<" comment " */"
  for (i = 2; i <= count; ++i) line = line " " type variable[i] "; /**<" comment " */"
  put(line)
  next
}
{ put($0) }
END { if (holds) print held }
