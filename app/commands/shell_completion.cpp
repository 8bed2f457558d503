// Completion scripts for bash, zsh and fish, made from the declared command line.
#include "app/bench/bench.hpp"
#include "app/commands/declared_words.hpp"
#include "app/commands/shell_documents.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr const char* kShells = "bash zsh fish";

/// Text in single quotes; `apostrophe` replaces each one in it.
std::string quoted(const std::string& text, const std::string& apostrophe) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? apostrophe : std::string(1, c);
    return result + "'";
}

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// Names of the benchmark's suites, each once.
std::string suites() {
    std::vector<std::string> names;
    for (const BenchPart& part : benchParts())
        if (std::find(names.begin(), names.end(), part.suite) == names.end()) names.emplace_back(part.suite);
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : " ") + name;
    return list;
}

/// Words that a value may be, separated by blanks; empty if they are not known beforehand.
std::string wordsOf(ValueKind kind) {
    if (kind == ValueKind::suite) return suites();
    return kind == ValueKind::shell ? kShells : "";
}

// bash

constexpr const char* kBashHead = R"(# Completion of meltpool in bash. Made by 'meltpool completion bash'.
_meltpool_add() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY
}

_meltpool() {
    local program=$1 cur=$2 prev=$3 kind=free words='' options='' name command=''
    COMPREPLY=()
    if [[ $cur == = ]]; then cur=''; fi
    if [[ $prev == = ]]; then prev=${COMP_WORDS[COMP_CWORD - 2]}; fi
    if ((COMP_CWORD > 1)); then command=${COMP_WORDS[1]}; fi
    case $command in
)";

// A lesson's name is never expanded: it is the name of a file, which may hold anything.
constexpr const char* kBashTail = R"(    esac
    if [[ $cur == -* ]]; then
        _meltpool_add < <(compgen -W "$options" -- "$cur")
        return
    fi
    case $kind in
    words) _meltpool_add < <(compgen -W "$words" -- "$cur") ;;
    setting)
        while IFS= read -r name; do
            if [[ $name == "$cur"* ]]; then COMPREPLY+=("$name"); fi
        done < <("$program" completion keys -- "${COMP_WORDS[@]:2}" 2>/dev/null)
        compopt -o nospace ;;
    lesson)
        while IFS= read -r name; do
            if [[ $name == "$cur"* ]]; then COMPREPLY+=("$name"); fi
        done < <("$program" completion lessons 2>/dev/null)
        _meltpool_add < <(compgen -f -X '!*.toml' -- "$cur")
        _meltpool_add < <(compgen -f -X '!*.meltpool' -- "$cur")
        _meltpool_add < <(compgen -d -- "$cur")
        compopt -o filenames ;;
    file)
        _meltpool_add < <(compgen -f -- "$cur")
        compopt -o filenames ;;
    folder)
        _meltpool_add < <(compgen -d -- "$cur")
        compopt -o filenames ;;
    esac
}

complete -F _meltpool meltpool
)";

/// Text "kind=file", or the possible words.
std::string bashKind(ValueKind kind) {
    if (const std::string words = wordsOf(kind); !words.empty()) return "kind=words words='" + words + "'";
    if (kind == ValueKind::file) return "kind=file";
    if (kind == ValueKind::folder) return "kind=folder";
    if (kind == ValueKind::setting) return "kind=setting";
    return kind == ValueKind::lesson ? "kind=lesson" : "kind=free";
}

std::string bashCommand(const DeclaredCommand& command, const std::string& names) {
    std::string text = "    " + (command.name.empty() ? "*" : command.name) + ")\n";
    std::string options, cases;
    for (const DeclaredWord& word : command.options) {
        options += (options.empty() ? "" : " ") + word.name;
        if (word.kind != ValueKind::none) cases += "        " + word.name + ") " + bashKind(word.kind) + " ;;\n";
    }
    text += "        options='" + options + "'\n";
    if (command.name.empty())
        text += "        if ((COMP_CWORD == 1)); then kind=words words='" + names + "'; fi\n";
    else if (!command.positionals.empty())
        text += "        " + bashKind(command.positionals.front().kind) + "\n";
    if (!cases.empty()) text += "        case $prev in\n" + cases + "        esac\n";
    return text + "        ;;\n";
}

std::string bashScript(const std::vector<DeclaredCommand>& commands) {
    std::string names;
    for (const DeclaredCommand& command : commands)
        if (!command.name.empty()) names += (names.empty() ? "" : " ") + command.name;
    std::string text = kBashHead;
    for (size_t i = 1; i <= commands.size(); ++i) // the program itself last: its pattern fits everything
        text += bashCommand(commands[i % commands.size()], names);
    return text + kBashTail;
}

// zsh

constexpr const char* kZshHead = R"(#compdef meltpool
# Completion of meltpool in zsh. Made by 'meltpool completion zsh'.
_meltpool_lessons() {
    local -a names
    names=("${(@f)$("$program" completion lessons 2>/dev/null)}")
    _alternative "lessons:lesson:compadd -a names" "files:file:_files -g '*.(toml|meltpool)'"
}

_meltpool_keys() {
    local -a keys
    keys=("${(@f)$("$program" completion keys -- "${words[@]}" 2>/dev/null)}")
    compadd -S '' -a keys
}

_meltpool() {
    local program=$words[1] command=$words[2]
    local -a commands
    commands=(
)";

std::string zshAction(ValueKind kind) {
    if (const std::string words = wordsOf(kind); !words.empty()) return "(" + words + ")";
    if (kind == ValueKind::file) return "_files";
    if (kind == ValueKind::folder) return "_files -/";
    if (kind == ValueKind::setting) return "_meltpool_keys";
    return kind == ValueKind::lesson ? "_meltpool_lessons" : " ";
}

/// Text inside an _arguments specification.
std::string zshText(const std::string& text) {
    std::string result;
    for (const char c : firstLine(text)) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string zshQuoted(const std::string& text) {
    return quoted(text, "'\\''");
}

std::string zshCommand(const DeclaredCommand& command) {
    std::string text = "        _arguments";
    for (const DeclaredWord& word : command.options) {
        std::string spec = (word.repeated ? "*" : "") + word.name + "[" + zshText(word.text) + "]";
        if (word.kind != ValueKind::none) spec += ":" + zshText(word.value) + ":" + zshAction(word.kind);
        text += " \\\n            " + zshQuoted(spec);
    }
    for (size_t i = 0; i < command.positionals.size(); ++i) {
        const DeclaredWord& word = command.positionals[i];
        text += " \\\n            " +
                zshQuoted((word.repeated ? "*" : std::to_string(i + 1)) + ":" + word.name + ":" + zshAction(word.kind));
    }
    return text + "\n";
}

std::string zshScript(const std::vector<DeclaredCommand>& commands) {
    std::string text = kZshHead;
    std::string cases;
    for (const DeclaredCommand& command : commands) {
        if (command.name.empty()) continue;
        text += "        " + zshQuoted(command.name + ":" + zshText(command.text)) + "\n";
        cases += "    " + command.name + ")\n        shift words\n        ((CURRENT--))\n" + zshCommand(command) +
                 "        ;;\n";
    }
    text += "    )\n    if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n"
            "        _describe command commands\n        return\n    fi\n    case $command in\n" +
            cases + "    *)\n" + zshCommand(commands.front()) + "        ;;\n    esac\n}\n\n";
    // Both ways work: read from a start-up file, and found by its name in a folder of functions.
    return text + "if [[ $funcstack[1] == _meltpool ]]; then _meltpool \"$@\"; else compdef _meltpool meltpool; fi\n";
}

// fish

std::string fishQuoted(const std::string& text) {
    std::string escaped;
    for (const char c : firstLine(text))
        escaped += c == '\\' ? std::string("\\\\") : std::string(1, c);
    return quoted(escaped, "\\'");
}

/// Options of `complete` for a value; empty if fish offers files by itself.
std::string fishValue(ValueKind kind) {
    if (const std::string words = wordsOf(kind); !words.empty()) return " -x -a " + fishQuoted(words);
    if (kind == ValueKind::file) return " -r -F";
    if (kind == ValueKind::folder) return " -x -a '(__fish_complete_directories)'";
    if (kind == ValueKind::setting) return " -x -a '(meltpool completion keys -- (commandline -opc)[2..] 2>/dev/null)'";
    if (kind == ValueKind::lesson)
        return " -x -a '(meltpool completion lessons 2>/dev/null; __fish_complete_suffix .toml)'";
    return " -x";
}

std::string fishScript(const std::vector<DeclaredCommand>& commands) {
    std::string text = "# Completion of meltpool in fish. Made by 'meltpool completion fish'.\n";
    for (const DeclaredCommand& command : commands) {
        const std::string when =
            command.name.empty() ? "__fish_use_subcommand" : "'__fish_seen_subcommand_from " + command.name + "'";
        const std::string line = "complete -c meltpool -n " + when;
        if (!command.name.empty())
            text += "complete -c meltpool -n __fish_use_subcommand -f -a " + command.name + " -d " +
                    fishQuoted(command.text) + "\n";
        for (const DeclaredWord& word : command.options)
            text += line + " -l " + word.name.substr(2) +
                    (word.kind == ValueKind::none ? std::string() : fishValue(word.kind)) + " -d " +
                    fishQuoted(word.text) + "\n";
        if (command.name.empty()) continue;
        const ValueKind first = command.positionals.empty() ? ValueKind::none : command.positionals.front().kind;
        if (first == ValueKind::none) text += line + " -f\n";
        if (first != ValueKind::none && first != ValueKind::file) text += line + fishValue(first) + "\n";
    }
    return text;
}

} // namespace

std::string completionScript(const CLI::App& app, std::string_view shell) {
    const std::vector<DeclaredCommand> commands = declaredCommands(app);
    if (shell == "bash") return bashScript(commands);
    if (shell == "zsh") return zshScript(commands);
    if (shell == "fish") return fishScript(commands);
    throw InputError("unknown shell " + quote(shell) + "; expected one of bash, zsh, fish");
}

} // namespace meltpool
