using Msisf.App.Settings.Specs;
using Msisf.Core.Render.Options;

namespace Msisf.App.Settings;

/// <summary>The options of the light that ground throws on ground.</summary>
internal static class IndirectOptions
{
    public static TextSpec Bounces { get; } = new(
        "--indirect", DecidesBytes.As(frame => frame.Native?.Render.Indirect?.Bounces), "BOUNCES",
        $"Ground also gets light from the ground around, reflected up to so many times before, 1 to {IndirectLight.MaxBounces}; 1 if no "
            + "number is given")
    {
        ValueIfBare = "1",
        DefaultNote = "the Sun's light alone",
    };

    public static NumberSpec Error { get; } = new(
        "--indirect-error", DecidesBytes.As(frame => frame.Native?.Render.Indirect?.Error), "PART",
        "Rms error of the light of --indirect, over its rms in the image; with a quarter frames take up to 16 times as long")
    {
        Default = IndirectLight.DefaultError,
        Limits = new NumberRange(IndirectLight.MinError, IndirectLight.MaxError),
    };

    /// <summary>Reads the options; null if no such light is asked for.</summary>
    /// <param name="scans">Whether the camera's rows have times of their own.</param>
    /// <exception cref="UsageException">A value is wrong, or has no meaning with others.</exception>
    public static IndirectLight? Read(OptionValues values, bool scans)
    {
        double error = Error.Read(values);
        if (Bounces.ReadIfGiven(values) is not { } text)
        {
            return !values.IsGiven(Error)
                ? null
                : throw Error.Wrong($"has no meaning without {Bounces.Name}. Add that, or leave it out.", Bounces);
        }

        if (!int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int bounces)
            || bounces is < 1 or > IndirectLight.MaxBounces)
        {
            throw Bounces.Wrong(Invariant($"is '{text}'; a whole number from 1 to {IndirectLight.MaxBounces} is needed."));
        }

        if (LightOptions.IgnoreSun.Read(values))
        {
            throw Bounces.Wrong(
                "needs the Sun's light on the ground, which --ignore-sun replaces by a lamp. Leave one of them out.",
                LightOptions.IgnoreSun);
        }

        return !scans
            ? new IndirectLight(bounces, error)
            : throw Bounces.Wrong(
                "is not for cameras that scan: the ground around would have to be lit anew for each of their rows. Leave it out, or take a "
                    + "camera that sees its image at once.", ImageOptions.Camera);
    }
}
