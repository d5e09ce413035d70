# Completion of rasterlens-cli for bash. The program itself knows how a command line may go on.
_rasterlens_cli()
{
    local cur words cword found
    _get_comp_words_by_ref -n := cur words cword
    mapfile -t found < <("${words[0]}" complete -- "${words[@]:1:cword}" 2>/dev/null)
    COMPREPLY=("${found[@]}")
    if [[ ${#found[@]} -gt 0 && ${found[-1]} == :files ]]; then
        unset 'COMPREPLY[-1]'
        mapfile -t found < <(compgen -f -- "$cur")
        COMPREPLY+=("${found[@]}")
        compopt -o filenames
    fi
    __ltrim_colon_completions "$cur"
}
complete -F _rasterlens_cli rasterlens-cli
