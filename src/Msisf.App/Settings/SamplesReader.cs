using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>Reads the option --samples: a square number, or auto with an error.</summary>
internal static class SamplesReader
{
    /// <summary>The word for as many samples as an error takes.</summary>
    public const string Auto = "auto";

    private const int Max = NativeRenderOptions.MaxSubsamplesPerAxis * NativeRenderOptions.MaxSubsamplesPerAxis;

    /// <summary>Reads the option.</summary>
    /// <param name="grey">The grey levels in which the error is meant.</param>
    /// <returns>Samples along a pixel's edge, 1 with auto, and the sampling of auto, else null.</returns>
    /// <exception cref="UsageException">The value is neither.</exception>
    public static (int SubsamplesPerAxis, AdaptiveSampling? Adaptive) Read(OptionValues values, GreyScale grey)
    {
        string text = NativeOptions.Samples.Read(values);
        string[] parts = text.Split(':', 2);
        return ChoiceSpec.IsSame(Auto, parts[0])
            ? (1, new AdaptiveSampling(parts.Length == 2 ? Error(parts[1]) : AdaptiveSampling.DefaultError, grey))
            : (SubsamplesPerAxis(text), null);
    }

    /// <summary>The option's value as it is written in a frame's arguments.</summary>
    public static string TextOf(NativeRenderOptions options) => options.Adaptive is { } adaptive
        ? $"{Auto}:{NumberSpec.TextOf(adaptive.Error)}"
        : (options.SubsamplesPerAxis * options.SubsamplesPerAxis).ToString(CultureInfo.InvariantCulture);

    private static double Error(string text)
    {
        NumberRange range = new(AdaptiveSampling.MinError, AdaptiveSampling.MaxError);
        return NumberText.TryParse(text, out double error) && range.Contains(error)
            ? error
            : throw new UsageException(
                $"--samples: the error of auto is '{text}'; levels of 255 in the range {range} are needed, as in auto:0.4.")
                .About(NativeOptions.Samples);
    }

    private static int SubsamplesPerAxis(string text)
    {
        if (!int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int samples) || samples is < 1 or > Max)
        {
            throw new UsageException(
                $"--samples is '{text}'; a square number from 1 to {Max.ToString(CultureInfo.InvariantCulture)} or auto[:ERROR] is needed.")
                .About(NativeOptions.Samples);
        }

        int perAxis = (int)Math.Sqrt(samples); // exact for numbers as small as these
        return perAxis * perAxis == samples
            ? perAxis
            : throw new UsageException(
                $"--samples is {samples}; the samples form a square grid, so a square number is needed: "
                    + $"{perAxis * perAxis} or {(perAxis + 1) * (perAxis + 1)}.")
                .About(NativeOptions.Samples);
    }
}
