# Completion of rasterlens-cli for fish. The program itself knows how a command line may go on.
function __rasterlens_cli
    set -l words (commandline -opc) (commandline -ct)
    set -l found ($words[1] complete -- $words[2..] 2>/dev/null)
    if test (count $found) -gt 0; and test "$found[-1]" = :files
        set -e found[-1]
        __fish_complete_path (commandline -ct)
    end
    string join \n -- $found
end
complete -c rasterlens-cli -f -a '(__rasterlens_cli)'
