using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Tests.Settings;

/// <summary>Options as a command line gives them.</summary>
internal static class Given
{
    /// <summary>The options of a run.</summary>
    /// <param name="words">"--name value" or "--flag", separated by blanks; no value has a blank or begins with "--".</param>
    public static OptionValues Options(string words)
    {
        Dictionary<string, OptionValue> values = [];
        string[] parts = words.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        for (int index = 0; index < parts.Length; index++)
        {
            string name = parts[index];
            OptionSpec option = CommandTable.All.SelectMany(command => command.Command.Options).First(option => option.Name == name);
            values.Add(name, new OptionValue(option is FlagSpec ? [] : [parts[++index]]));
        }

        return new OptionValues(values);
    }
}
