// The manual page in roff, with the texts of --help.
#include "app/commands/command_texts.hpp"
#include "app/commands/declared_words.hpp"
#include "app/commands/shell_documents.hpp"
#include "app/platform/program_info.hpp"

namespace meltpool {

namespace {

/// Text that roff shows unchanged: no request at the start of a line, and hyphens that can be copied.
std::string roff(std::string_view text) {
    std::string result;
    bool lineStarts = true;
    for (const char c : text) {
        if (lineStarts && (c == '.' || c == '\'')) result += "\\&";
        lineStarts = c == '\n';
        if (c == '\n')
            result += "\n.br\n";
        else if (c == '\\')
            result += "\\(rs";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

/// Usage of a command: "meltpool run [OPTIONS] LESSON".
std::string usageOf(const DeclaredCommand& command) {
    std::string usage = "meltpool" + (command.name.empty() ? "" : " " + command.name) + " [OPTIONS]";
    for (const DeclaredWord& word : command.positionals) {
        const std::string name = word.repeated ? word.name + ".." : word.name;
        usage += word.required ? " " + name : " [" + name + "]";
    }
    return usage;
}

std::string item(std::string_view head, std::string_view value, std::string_view text) {
    std::string lines = ".TP\n\\fB" + roff(head) + "\\fR";
    if (!value.empty()) lines += " \\fI" + roff(value) + "\\fR";
    return lines + "\n" + roff(text) + "\n";
}

/// Every option with its text.
std::string optionsOf(const DeclaredCommand& command) {
    std::string text;
    for (const DeclaredWord& word : command.positionals)
        text += item(word.name, {}, word.text);
    for (const DeclaredWord& word : command.options)
        text += item(word.name, word.value, word.text);
    return text;
}

} // namespace

std::string manualPage(const CLI::App& app) {
    const std::vector<DeclaredCommand> commands = declaredCommands(app);
    // The version in the date's place: printed again, the page is identical.
    std::string text = ".TH MELTPOOL 1 \"version " + roff(programVersion()) + "\" \"Meltpool\" \"User Commands\"\n";
    text += ".SH NAME\nmeltpool \\- virtual welding trainer\n.SH SYNOPSIS\n";
    for (const DeclaredCommand& command : commands)
        text += ".B " + roff(usageOf(command)) + "\n.br\n";
    text += ".SH DESCRIPTION\n" + roff(commands.front().text) + "\n";
    text += ".SH OPTIONS\n" + optionsOf(commands.front());
    text += ".SH COMMANDS\n";
    for (const DeclaredCommand& command : commands)
        if (!command.name.empty())
            text += ".SS " + roff(usageOf(command)) + "\n" + roff(command.text) + ".\n" + optionsOf(command);
    text += ".SH EXAMPLES\n";
    for (const NamedText& example : kExamples)
        text += item(example.name, {}, example.text);
    text += ".SH EXIT STATUS\n";
    for (const NamedText& code : kExitCodes)
        text += item(code.name, {}, code.text);
    text += ".SH ENVIRONMENT\n";
    for (const NamedText& variable : kVariables)
        text += item(variable.name, {}, std::string(variable.text) + ".");
    return text;
}

} // namespace meltpool
