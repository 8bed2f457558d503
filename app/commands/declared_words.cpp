#include "app/commands/declared_words.hpp"

#include <map>

namespace meltpool {

namespace {

/// Kind of a value by its name. A folder that is read may be the folder of a run or one of its files.
ValueKind kindOf(const std::string& value, bool positional) {
    static const std::map<std::string, ValueKind> kinds{
        {"LESSON", ValueKind::lesson}, {"CHECK", ValueKind::lesson}, {"DIR", ValueKind::folder},
        {"FOLDER", ValueKind::folder}, {"FILE", ValueKind::file},    {"CASE", ValueKind::file},
        {"A", ValueKind::file},        {"B", ValueKind::file},       {"[FILE] OUT", ValueKind::file},
        {"SUITE", ValueKind::suite},   {"SHELL", ValueKind::shell}};
    const auto known = kinds.find(value);
    if (known == kinds.end()) return ValueKind::free;
    return positional && known->second == ValueKind::folder ? ValueKind::file : known->second;
}

DeclaredWord wordOf(const CLI::Option& option) {
    DeclaredWord word;
    const bool positional = option.get_lnames().empty() && option.get_snames().empty();
    word.name = positional ? option.get_name(true) : "--" + option.get_lnames().front();
    word.text = option.get_description();
    word.required = option.get_required();
    const bool flag = option.get_items_expected_max() == 0;
    word.repeated = !flag && option.get_items_expected_max() > 2;
    if (flag) return word;
    word.value = positional ? word.name : option.get_type_name();
    word.kind = word.name == "--set" ? ValueKind::setting : kindOf(word.value, positional);
    return word;
}

DeclaredCommand commandOf(const CLI::App& app, const std::string& name) {
    DeclaredCommand command{name, app.get_description(), {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue; // hidden options are for completion scripts only
        DeclaredWord word = wordOf(*option);
        const bool positional = !word.name.starts_with("--");
        (positional ? command.positionals : command.options).push_back(std::move(word));
    }
    return command;
}

} // namespace

std::vector<DeclaredCommand> declaredCommands(const CLI::App& app) {
    std::vector<DeclaredCommand> commands{commandOf(app, "")};
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!command->get_group().empty()) commands.push_back(commandOf(*command, command->get_name()));
    return commands;
}

} // namespace meltpool
