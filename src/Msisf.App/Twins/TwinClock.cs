using System.Buffers.Binary;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Adapters.RealImages;
using Msisf.Core.Time;

namespace Msisf.App.Twins;

/// <summary>Turns the times of a label into TDB seconds past J2000.</summary>
/// <param name="kernels">Has the leap seconds, and perhaps the spacecraft's clock.</param>
/// <param name="spacecraft">NAIF's number.</param>
internal sealed class TwinClock(ImageLabel label, OpenedEphemeris kernels, int spacecraft)
{
    private const string Computed = "_COMPUTED";

    /// <summary>The time of a count of the spacecraft's clock; null without the keyword, or if nothing here knows the clock.</summary>
    /// <exception cref="BadInputException">It is no count.</exception>
    public double? OfCount(string name) => OfCube(name)
        ?? (label.Find(name) is { } count && SpacecraftClock.IsIn(kernels.Catalogue.Pool, spacecraft)
            ? SpacecraftClock.Read(kernels.Catalogue.Pool, spacecraft, kernels.Engine.TimeScale).TimeOf(count.Text)
            : null);

    /// <summary>The time of a count as a cube has kept it: ISIS stores the clock's answer as the bytes of a double.</summary>
    /// <param name="name">The keyword of the count.</param>
    /// <returns>Null if the cube has none.</returns>
    /// <exception cref="BadInputException">It is no time.</exception>
    public double? OfCube(string name)
    {
        string? known = label.Find(name) is not { Text: var count } ? null : label.Naif.Keys.FirstOrDefault(
            key => key.StartsWith("CLOCK_ET_", StringComparison.Ordinal) && key.EndsWith($"_{count}{Computed}", StringComparison.Ordinal));
        return known is null ? null
            : label.Naif[known].Text is var hex && hex.Length == 2 * sizeof(double) && hex.All(char.IsAsciiHexDigit)
                ? BinaryPrimitives.ReadDoubleLittleEndian(Convert.FromHexString(hex))
            : throw new BadInputException($"{label.Path}: {known} is '{hex}'; 16 hexadecimal digits are needed.");
    }

    /// <summary>The time of a keyword in UTC.</summary>
    /// <exception cref="BadInputException">It is missing, or no time.</exception>
    public double OfUtc(string name)
    {
        string text = label.Text(name);
        return TimeText.TryParse(text.EndsWith('Z') ? text : text + "Z", out double mjd)
            ? kernels.Engine.TimeScale.FromUtc(new ModifiedJulianDate(mjd))
            : throw new BadInputException(
                text.Length == 0
                    ? $"{label.Path}: the label has no {name}: when the image was taken is not known."
                    : $"{label.Path}: {name} is '{text}'; a time such as 2009-07-30T12:20:38.185 is needed.");
    }
}
