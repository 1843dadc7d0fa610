# offered.zsh FOLDER LOG LINE...: what zsh offers after each line, completed in a pseudo-terminal with the completion
# files of FOLDER. LOG gets a line "== LINE" for each, then the words offered.
zmodload zsh/zpty
folder=$1 log=$2
shift 2
: >$log
zpty shell zsh -f -i
zpty -w shell "PS1=; fpath=($folder \$fpath); autoload -Uz compinit; compinit -D -u; log=$log"'
  offer() {
    compadd() { local -a matches; builtin compadd -O matches "$@"; print -rl -- $matches >>$log; builtin compadd "$@" }
    print -r -- "== $BUFFER" >>$log; _main_complete; print END >>$log
  }
  zle -C offer complete-word offer; bindkey "^I" offer; bindkey "^U" kill-whole-line; print READY$((1))'
zpty -r -m shell answer '*READY1*'
for line; do
  : $((lines++))
  zpty -n -w shell "$line"$'\t'
  until [[ $(grep -c END $log) -eq $lines ]]; do sleep 0.02; done
  zpty -n -w shell $'\C-u'
done
zpty -d shell
