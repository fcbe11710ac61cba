# What takes turns by the date in a run of everything.
include_guard(GLOBAL)
option(ZSTRIP_TARGETS_IN_TURN "Of targets and processors whose code is nearly one, only those of today" OFF)
# One day for all, or at midnight some would have one and others the next.
string(TIMESTAMP seconds "%s" UTC)
math(EXPR day "${seconds} / 86400")
set_property(GLOBAL PROPERTY ZSTRIP_DAY ${day})

# zstrip_is_today(RESULT NUMBER DAYS): whether it is the turn of what has this number; one of as many as DAYS is.
function(zstrip_is_today result number days)
  get_property(day GLOBAL PROPERTY ZSTRIP_DAY)
  math(EXPR days_left "(${number} - ${day}) % ${days}")
  set(${result} ON PARENT_SCOPE)
  if(ZSTRIP_TARGETS_IN_TURN AND NOT days_left EQUAL 0)
    set(${result} OFF PARENT_SCOPE)
  endif()
endfunction()
