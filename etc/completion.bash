# Completion of the programs' options in bash: what `<program> -help` says, so that it never disagrees.
_pfem() {
    local word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD - 1]}" help
    help=$("$1" -help 2> /dev/null)
    case "$word" in
        -*)
            COMPREPLY=($(compgen -W "$(printf '%s\n' "$help" | sed -n 's/^  \(-[A-Za-z][A-Za-z-]*\).*/\1/p')" -- "$word"))
            return
            ;;
    esac
    case "$before" in
        -case) COMPREPLY=($(compgen -d -- "$word")) ;;
        -time) COMPREPLY=($(compgen -W "$(pfemListTimes 2> /dev/null)" -- "$word")) ;;
        *) COMPREPLY=($(compgen -f -- "$word")) ;;
    esac
}
complete -o filenames -F _pfem pfemNewCase pfemMesh pfemFsiFoam pfemProbe pfemPostProcess pfemCheckMesh pfemListTimes pfemMassCheck pfemSnapshot pfemBounds pfemSweep pfemDictionary pfemHistory pfemAnimate
