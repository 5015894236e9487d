# What bash offers behind the command pcl_emtr. The options and their values are read from its own
# --help-all, so that they are those of the command that is installed.
# shellcheck shell=bash

# Prints a line for each option: its name, what stands for its value, and the values that there are.
_pcl_emtr_options() {
  "$1" --help-all 2>/dev/null | awk '
    function flush() {
      if (name == "") return
      values = ""
      if (kind ~ /\|/) values = kind
      else if (match(text, /\[[^];]* or [^];]*; default/)) values = substr(text, RSTART + 1, RLENGTH - 10)
      else if (match(text, /: [a-z]+(, [a-z]+)* or [a-z]+$/)) values = substr(text, RSTART + 2)
      gsub(/\||, | or /, " ", values)
      print name, (kind == "" ? "-" : kind), values
      name = ""
    }
    /^  -/ {
      flush()
      match($0, /--[a-z-]+/)
      name = substr($0, RSTART, RLENGTH)
      line = substr($0, RSTART + RLENGTH)
      kind = match(line, /^ [^ ]+/) ? substr(line, 2, RLENGTH - 1) : ""
      text = substr($0, 35)
      next
    }
    /^          / { sub(/^ +/, ""); text = text (text == "" ? "" : " ") $0; next }
    { flush() }
    END { flush() }'
}

_pcl_emtr() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} name values
  COMPREPLY=()
  # Bash makes three words of --preset=fast.
  if [[ $current == "=" ]]; then
    current=
  elif [[ $previous == "=" ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case $previous in -o) previous=--output ;; esac
  while read -r name _ values; do
    if [[ $current == -* ]]; then
      [[ $name != "$current"* ]] || COMPREPLY+=("$name")
    elif [[ $name == "$previous" && -n $values ]]; then
      mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
    fi
  done < <(_pcl_emtr_options "${COMP_WORDS[0]}")
}

# Where nothing is offered, bash offers files.
complete -o default -F _pcl_emtr pcl_emtr
