using Msisf.Adapters.Input;
using Msisf.Core.Certainty;

namespace Msisf.App.Settings;

/// <summary>Reads how accurately an image's ground, camera and Sun are known.</summary>
internal static class LimitsText
{
    private const string Keys = "height, step and position in m, turn and sun in degrees";

    /// <summary>m: above all mountains, and farther than cameras are known badly.</summary>
    private const double MostMetres = 1e5;

    /// <summary>Degrees.</summary>
    private const double MostDegrees = 10.0;

    /// <summary>Reads a text such as "height=1,position=10".</summary>
    /// <param name="sigmas">By what all but the step are multiplied.</param>
    /// <exception cref="UsageException">The text is wrong.</exception>
    public static Uncertainty Parse(string text, double sigmas)
    {
        Dictionary<string, double> values = new(StringComparer.OrdinalIgnoreCase);
        foreach (string part in text.Split(',', StringSplitOptions.TrimEntries))
        {
            string[] pair = part.Split('=', StringSplitOptions.TrimEntries);
            bool isAngle = pair[0].ToLowerInvariant() is "turn" or "sun";
            if (pair.Length != 2 || !(isAngle || pair[0].ToLowerInvariant() is "height" or "step" or "position"))
            {
                throw new UsageException($"'{part}' is not a limit. Give some of {Keys}: height=1,position=10.");
            }

            double most = isAngle ? MostDegrees : MostMetres;
            if (!NumberText.TryParse(pair[1], out double value) || !(value >= 0.0 && value <= most))
            {
                throw new UsageException($"'{part}': a number from 0 to {most.ToString("R", CultureInfo.InvariantCulture)} is needed.");
            }

            if (!values.TryAdd(pair[0], value))
            {
                throw new UsageException($"'{pair[0]}' is given twice. Give each limit once.");
            }
        }

        return new Uncertainty(
            (sigmas * Of("height")) + (0.5 * Of("step")), sigmas * Of("position"), double.DegreesToRadians(sigmas * Of("turn")),
            double.DegreesToRadians(sigmas * Of("sun")));

        double Of(string key) => values.GetValueOrDefault(key);
    }
}
