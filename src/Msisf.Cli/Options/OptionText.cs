using System.CommandLine;
using System.Globalization;
using Msisf.Adapters.Input;
using Msisf.Core.Errors;

namespace Msisf.Cli.Options;

/// <summary>Reads single option values.</summary>
internal static class OptionText
{
    /// <summary>A whole number in a range.</summary>
    /// <exception cref="BadInputException">None, or out of range.</exception>
    public static int WholeNumber(Option option, string text, int minimum, int maximum) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && value >= minimum
            && value <= maximum
            ? value
            : throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture, $"{option.Name} is '{text}'; a whole number from {minimum} to {maximum} is needed."));

    /// <summary>A finite number.</summary>
    /// <exception cref="BadInputException">None.</exception>
    public static double Number(Option option, string text) =>
        NumberText.TryParse(text, out double value)
            ? value
            : throw new BadInputException($"{option.Name}: {NumberText.ProblemWith(text)}.");

    /// <summary>One of a few words.</summary>
    /// <exception cref="BadInputException">Another word.</exception>
    public static T Choice<T>(Option option, string text, IReadOnlyList<(string Word, T Value)> choices)
    {
        foreach ((string word, T value) in choices)
        {
            if (word == text)
            {
                return value;
            }
        }

        throw new BadInputException(
            $"{option.Name} is '{text}'; one of {string.Join(", ", choices.Select(choice => choice.Word))} is needed.");
    }

    /// <summary>A path that is not empty.</summary>
    /// <exception cref="BadInputException">Empty.</exception>
    public static string FilePath(Option option, string text) =>
        text.Trim().Length > 0 ? text : throw new BadInputException($"{option.Name} is empty; a path is needed.");

    /// <summary>Makes a value; what is wrong with it is told with the option's name before it.</summary>
    public static T Named<T>(Option option, Func<T> make)
    {
        try
        {
            return make();
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{option.Name}: {exception.Message}", exception);
        }
    }
}
