using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The value of --reflectance, such as "hapke:w=0.3,b0=1.2".</summary>
internal static class ReflectanceText
{
    /// <summary>The law's name and its parameters, both in lower case.</summary>
    /// <exception cref="UsageException">A parameter has no number or is given twice, or the name resembles a law's.</exception>
    public static (string Law, SortedDictionary<string, double> Parameters) Parse(string text)
    {
        (string law, string[] given) = Split(text);
        SortedDictionary<string, double> parameters = new(StringComparer.Ordinal);
        foreach (string parameter in given)
        {
            string[] pair = Pair(parameter);
            if (pair.Length != 2 || !NumberText.TryParse(pair[1], out double value))
            {
                throw new UsageException($"--reflectance: '{parameter}' is no parameter; "
                    + $"name=number is needed, as in hapke:w=0.3,b0=1.2.").About(NativeOptions.Reflectance);
            }

            if (!parameters.TryAdd(pair[0], value))
            {
                throw new UsageException(
                    $"--reflectance: the parameter {pair[0]} is given twice. Leave one out.").About(NativeOptions.Reflectance);
            }
        }

        return NativeOptions.Reflectance.Words.Contains(law) || NearestName.Question(
            law, NativeOptions.Reflectance.Words) is not { Length: > 0 } question
            ? (law, parameters)
            : throw new UsageException($"{NativeOptions.Reflectance.Name}: '{law}' is no law{question}").About(NativeOptions.Reflectance);
    }

    /// <summary>Whether a text, right or wrong, names a law with a brightness of its own, beside which no albedo can be given.</summary>
    public static bool IsAbsolute(string text)
    {
        (string law, string[] given) = Split(text);
        return ReflectanceFactory.IsAbsolute(law, given.Select(parameter => Pair(parameter)[0]));
    }

    private static (string Law, string[] Parameters) Split(string text)
    {
        string[] parts = text.ToLowerInvariant().Split(':', 2);
        return (parts[0].Trim(), parts.Length == 2 ? parts[1].Split(',') : []);
    }

    private static string[] Pair(string parameter) => parameter.Split('=', 2, StringSplitOptions.TrimEntries);
}
