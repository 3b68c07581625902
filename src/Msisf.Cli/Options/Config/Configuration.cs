using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Parsing;
using System.Text.RegularExpressions;
using Msisf.App.Host;

namespace Msisf.Cli.Options.Config;

/// <summary>
/// Puts the values of the configuration files behind a command line, as defaults of the options that are not given there: what reads and
/// checks the options does not see a difference, but for "is it given".
/// </summary>
internal sealed class Configuration
{
    private readonly RootCommand _root;
    private readonly ProgramHost _host;
    private readonly ParserConfiguration _parser = new() { ResponseFileTokenReplacer = ResponseFile.TryRead };
    private readonly Lazy<ConfigKeys> _keys;
    private IReadOnlyDictionary<string, ConfigValue>? _values;
    private IReadOnlyCollection<ConfigValue> _applied = [];

    /// <summary>Declares <c>--config</c> for a command and all below it.</summary>
    public Configuration(RootCommand root, ProgramHost host)
    {
        (_root, _host, _keys) = (root, host, new Lazy<ConfigKeys>(() => new ConfigKeys(root)));
        FileOption = OptionFactory.Value(
            "--config", [], "FILE",
            "Settings for the options that are not given, one 'key: value' a line; they go before those of ~/.config/msisf/config.yaml");
        FileOption.Recursive = true;
        root.Options.Add(FileOption);
    }

    public Option<string?> FileOption { get; }

    /// <summary>What may stand in a file; asked for when all commands are declared.</summary>
    public ConfigKeys Keys => _keys.Value;

    /// <summary>What the files of this call say; they are read once.</summary>
    /// <param name="given">The user's <c>--config</c>, or null.</param>
    public IReadOnlyDictionary<string, ConfigValue> ValuesOf(string? given) => _values ??= new ConfigFiles(Keys, _host).Read(given);

    /// <summary>Reads a command line, and the configuration files if it asks for work.</summary>
    public ParseResult Parse(IReadOnlyList<string> arguments)
    {
        ParseResult line = _root.Parse([.. arguments], _parser);
        if (AsksForHelp(line) || arguments.Count == 0)
        {
            return line;
        }

        string? given = line.GetResult(FileOption)?.Tokens is [Token token] ? token.Value : null;
        bool hasUserFile = ConfigFiles.UserFile(_host) is { } path && ConfigFiles.IsThere(path);
        if (given is null && !(hasUserFile && line.CommandResult.Command.Options.Any(Keys.Allows)))
        {
            return line; // by far the most calls: no file is looked at
        }

        return Apply(ValuesOf(given), line) ? _root.Parse([.. arguments], _parser) : line;
    }

    /// <summary>A message with the place of the setting that its first sentence is about, if that comes from a file.</summary>
    public string WithOrigin(string message)
    {
        int end = message.IndexOf(". ", StringComparison.Ordinal);
        string sentence = end < 0 ? message : message[..end];
        return _applied.FirstOrDefault(value => IsAbout(sentence, value)) is { } source
            ? $"{message} --{source.Key} comes from {source.File}, line {source.Line}."
            : message;
    }

    private bool Apply(IReadOnlyDictionary<string, ConfigValue> values, ParseResult line)
    {
        Dictionary<string, Option> options = line.CommandResult.Command.Options.ToDictionary(ConfigKeys.KeyOf, StringComparer.Ordinal);
        Dictionary<string, ConfigValue> ofCommand = new(values.Where(pair => options.ContainsKey(pair.Key)), StringComparer.Ordinal);
        string? OnLine(string key) => options.TryGetValue(key, out Option? option) && line.GetResult(option) is { Implicit: false } given
            ? string.Join(' ', given.Tokens.Select(token => token.Value))
            : null;
        _applied = [.. ConfigRules.Applicable(ofCommand, OnLine, draws: options.ContainsKey("renderer")).Values];
        foreach (ConfigValue value in _applied)
        {
            SetDefault(options[value.Key], value.Text);
        }

        return _applied.Count > 0;
    }

    private static void SetDefault(Option option, string text)
    {
        if (option is Option<bool> flag)
        {
            flag.DefaultValueFactory = _ => text == "true";
        }
        else
        {
            ((Option<string?>)option).DefaultValueFactory = _ => text;
        }
    }

    private static bool AsksForHelp(ParseResult line) =>
        line.CommandResult.Children.OfType<OptionResult>().Any(given => given.Option is HelpOption or VersionOption && !given.Implicit);

    private static bool IsAbout(string sentence, ConfigValue value) =>
        Regex.IsMatch(sentence, $@"(?<![\w-])--{Regex.Escape(value.Key)}(?![\w-])")
        || (value.Text.Length > 3 && value.Text.Any(char.IsLetter) && sentence.Contains(value.Text, StringComparison.Ordinal));
}
