using Msisf.Core.Scene;

namespace Msisf.Adapters.Input;

/// <summary>Reads and writes a noise seed: <c>N</c>, a whole number, or <c>N:STEP</c> with the number of the frame.</summary>
public static class NoiseSeedText
{
    /// <summary>What the text may look like, for messages.</summary>
    public const string ValidValues = "a whole number from 0 on, or two with a colon between them: N:STEP";

    /// <summary>Reads a seed.</summary>
    /// <param name="step">Number of the frame if the text has none.</param>
    /// <exception cref="BadInputException">It is no such text.</exception>
    public static NoiseSeed Parse(string text, ulong step)
    {
        string[] parts = text.Split(':');
        return parts.Length <= 2 && TryParse(parts[0], out ulong number) && (parts.Length == 1 || TryParse(parts[1], out step))
            ? new NoiseSeed(number, step)
            : throw new BadInputException($"{NumberText.Shown(text)} is no noise seed; {ValidValues}.");
    }

    /// <summary>The text of a seed with its step.</summary>
    public static string Of(NoiseSeed seed) => Invariant($"{seed.Number}:{seed.Step}");

    private static bool TryParse(string text, out ulong number) =>
        ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}
