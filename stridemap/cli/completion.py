"""``stridemap completion``: a script by which a shell completes commands, options, models and parameters.

The script holds all words, so that completing starts no Python and takes no time; after an update it is to be
printed anew.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import typer

from stridemap.cli.options import FOUND, PARAMETERS
from stridemap.errors import InputError


@dataclass(frozen=True)
class Word:
    """An option or a command as a shell completes it.

    Parameters
    ----------
    word, help : str
    takes_value : bool
        Whether another word belongs to it.
    """

    word: str
    help: str
    takes_value: bool = False


@dataclass(frozen=True)
class Words:
    """All that a shell completes.

    Parameters
    ----------
    commands : mapping of Word to tuple of Word
        The options of each command.
    with_parameters : tuple of str
        Commands that take the parameters of a model as options.
    parameters : mapping of str to tuple of Word
        The parameters of each built-in model.
    """

    commands: Mapping[Word, tuple[Word, ...]]
    with_parameters: tuple[str, ...]
    parameters: Mapping[str, tuple[Word, ...]]


def completion(
    context: typer.Context,
    shell: Annotated[str, typer.Argument(metavar="bash|zsh|fish", help="The shell that completes.")],
) -> int:
    """Print a script by which a shell completes commands, options, models and parameters.

    bash: eval "$(stridemap completion bash)" in ~/.bashrc. zsh: eval "$(stridemap completion zsh)" in
    ~/.zshrc, after compinit. fish: stridemap completion fish > ~/.config/fish/completions/stridemap.fish
    """
    if shell not in SHELLS:
        raise InputError(
            f"{shell!r} is not a shell that can be completed for; shells are {', '.join(SHELLS)}"
        )
    assert context.parent is not None
    print(SHELLS[shell](words_of(context.parent.command)))
    return FOUND


def words_of(group: Any) -> Words:
    """What there is to complete, from the command line itself and the built-in models."""
    from stridemap.solver.model.loading import available, load

    commands = {
        Word(name, _first(command.get_short_help_str(200))): tuple(_options(command))
        for name, command in group.commands.items()
    }
    taking = tuple(
        name
        for name, one in group.commands.items()
        if PARAMETERS.items() <= dict(one.context_settings).items()
    )
    models = {
        name: tuple(
            Word(f"--{a.name}", _plain(f"{a.meaning} [{a.unit}]"), True) for a in load(name).parameters
        )
        for name in available()
    }
    return Words(commands, taking, models)


def _options(command: Any) -> Iterator[Word]:
    for one in command.params:
        if one.param_type_name == "option":
            for word in one.opts:
                yield Word(word, _first(one.help or ""), not one.is_flag)
    yield Word("--help", "Show this message and exit.")


def _first(text: str) -> str:
    """The first sentence of a help text."""
    sentence = re.split(r"(?<=[.;])\s", text.strip())[0].rstrip(".;")
    return _plain(sentence)


def _plain(text: str) -> str:
    """A text without quotation marks and what else a shell reads as its own."""
    return re.sub(r"[^\w ,.()\[\]/=<>+*%’-]", "", text.replace("'", "’"))


# -- bash ----------------------------------------------------------------------------------------------------


def bash(words: Words) -> str:
    """A script for bash."""
    cases = [
        f"    {command.word}) options={_listed(options)} "
        f"values={_listed(one for one in options if one.takes_value)};;"
        for command, options in words.commands.items()
    ]
    models = [f"      {name}) more={_listed(found)};;" for name, found in words.parameters.items()]
    return "\n".join(
        [
            '# Completes stridemap in bash: eval "$(stridemap completion bash)"',
            "_stridemap() {",
            '  local word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}"',
            '  local command="${COMP_WORDS[1]}" model=wobbling options="" values="" more="" i',
            "  COMPREPLY=()",
            "  if (( COMP_CWORD == 1 )); then",
            f'    COMPREPLY=($(compgen -W {_listed([*words.commands, *TOP])} -- "$word"))',
            "    return",
            "  fi",
            "  # --model=NAME comes in three words, since = divides them.",
            '  if [[ "$before" == "=" ]]; then before="${COMP_WORDS[COMP_CWORD-2]}"; fi',
            '  if [[ "$word" == "=" ]]; then word=""; fi',
            '  case "$command" in',
            *cases,
            "    *) return;;",
            "  esac",
            "  for (( i = 2; i < COMP_CWORD; i++ )); do",
            '    if [[ "${COMP_WORDS[i]}" == "--model" ]]; then',
            '      model="${COMP_WORDS[i+1]}"',
            '      if [[ "$model" == "=" ]]; then model="${COMP_WORDS[i+2]}"; fi',
            "    fi",
            "  done",
            f'  if [[ " {" ".join(words.with_parameters)} " == *" $command "* ]]; then',
            '    case "$model" in',
            *models,
            "    esac",
            "  fi",
            '  case "$before" in',
            f'    --model) COMPREPLY=($(compgen -W "{" ".join(words.parameters)}" -- "$word") '
            '$(compgen -f -X "!*.py" -- "$word") $(compgen -d -- "$word")); return;;',
            '    --vary) COMPREPLY=($(compgen -W "${more//--/}" -- "$word")); return;;',
            "  esac",
            '  if [[ "$command" == models && "$word" != -* ]]; then',
            f'    COMPREPLY=($(compgen -W "{" ".join(words.parameters)}" -- "$word")); return',
            "  fi",
            '  if [[ "$command" == completion && "$word" != -* ]]; then',
            f'    COMPREPLY=($(compgen -W "{" ".join(SHELLS)}" -- "$word")); return',
            "  fi",
            '  if [[ " $values $more " == *" $before "* || "$word" != -* ]]; then',
            '    COMPREPLY=($(compgen -f -- "$word")); return',
            "  fi",
            '  COMPREPLY=($(compgen -W "$options $more" -- "$word"))',
            "}",
            "complete -o filenames -F _stridemap stridemap",
        ]
    )


def _listed(words: Any) -> str:
    """Words in quotation marks, as one."""
    return f'"{" ".join(one.word for one in words)}"'


# -- zsh -----------------------------------------------------------------------------------------------------


def zsh(words: Words) -> str:
    """A script for zsh."""

    def spec(one: Word) -> str:
        help_ = re.sub(r"([\[\]:])", r"\\\1", one.help)
        argument = ""
        if one.word == "--model":
            argument = ":model:_stridemap_models"
        elif one.takes_value:
            argument = ":value:_files"
        return f"'*{one.word}[{help_}]{argument}'"

    models = "\n".join(
        f"    {name}) parameters=({' '.join(map(spec, found))});;" for name, found in words.parameters.items()
    )
    cases = []
    for command, options in words.commands.items():
        more = ' "${parameters[@]}"' if command.word in words.with_parameters else ""
        argument = {
            "models": "'1:model:_stridemap_models'",
            "completion": f"'1:shell:({' '.join(SHELLS)})'",
        }.get(command.word, "'*:file:_files'")
        cases.append(f"    {command.word}) _arguments {' '.join(map(spec, options))}{more} {argument};;")
    listed = "\n".join(f"    '{one.word}:{one.help}'" for one in words.commands)
    return f"""#compdef stridemap
# Completes stridemap in zsh: eval "$(stridemap completion zsh)", after compinit.
_stridemap_models() {{
  _alternative 'models:model:({" ".join(words.parameters)})' \\
    'files:model file:_files -g "*.py(-.)"' 'folders:derived folder:_files -/'
}}
_stridemap() {{
  local -a commands parameters
  local model=wobbling i
  commands=(
{listed}
  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  for (( i = 3; i < CURRENT; i++ )); do
    [[ "$words[i]" == --model ]] && model="$words[i+1]"
    [[ "$words[i]" == --model=* ]] && model="${{words[i]#--model=}}"
  done
  case "$model" in
{models}
  esac
  local command="$words[2]"
  shift words
  (( CURRENT-- ))
  case "$command" in
{chr(10).join(cases)}
  esac
}}
compdef _stridemap stridemap"""


# -- fish ----------------------------------------------------------------------------------------------------


def fish(words: Words) -> str:
    """A script for fish."""
    names = " ".join(one.word for one in words.commands)
    lines = [
        "# Completes stridemap in fish:",
        "# stridemap completion fish > ~/.config/fish/completions/stridemap.fish",
        "function __stridemap_model",
        "    set -l words (commandline -opc)",
        "    set -l model wobbling",
        "    for i in (seq (count $words))",
        '        if test "$words[$i]" = --model; and test (count $words) -gt $i',
        "            set model $words[(math $i + 1)]",
        '        else if string match -q -- "--model=*" "$words[$i]"',
        '            set model (string replace -- --model= "" "$words[$i]")',
        "        end",
        "    end",
        "    echo $model",
        "end",
    ]
    for command, options in words.commands.items():
        lines.append(
            f"complete -c stridemap -f -n 'not __fish_seen_subcommand_from {names}' -a {command.word} "
            f"-d '{command.help}'"
        )
        seen = f"-n '__fish_seen_subcommand_from {command.word}'"
        for one in options:
            value = ""
            if one.word == "--model":
                value = f" -x -a '{' '.join(words.parameters)} (__fish_complete_suffix .py)'"
            elif one.takes_value:
                value = " -r"
            lines.append(f"complete -c stridemap {seen} -l {one.word[2:]}{value} -d '{one.help}'")
    taking = " ".join(words.with_parameters)
    for name, found in words.parameters.items():
        when = f"-n '__fish_seen_subcommand_from {taking}; and test (__stridemap_model) = {name}'"
        lines += [f"complete -c stridemap {when} -l {one.word[2:]} -x -d '{one.help}'" for one in found]
    lines.append(
        f"complete -c stridemap -f -n '__fish_seen_subcommand_from models' -a '{' '.join(words.parameters)}'"
    )
    lines.append(
        f"complete -c stridemap -f -n '__fish_seen_subcommand_from completion' -a '{' '.join(SHELLS)}'"
    )
    return "\n".join(lines)


TOP = (Word("--help", "Show this message and exit."), Word("--version", "Print the version and exit."))
SHELLS: Mapping[str, Callable[[Words], str]] = {"bash": bash, "zsh": zsh, "fish": fish}
"""Shells, and what writes the script of each."""
