using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.Adapters.Input;

/// <summary>Writes batch files (thesis section 6.3.2). <see cref="BatchFileReader"/> reads the same states back, bit for bit.</summary>
public static class BatchFileWriter
{
    /// <summary>
    /// Writes all states: as the thesis has them, or with named columns if they have noise seeds, exposures or a Sun of their own.
    /// </summary>
    /// <param name="writer">Gets the text, about 160 bytes a state.</param>
    /// <param name="head">A comment of one line at the top, without control characters.</param>
    /// <param name="states">In the order of their lines; all with noise seed, or none; so with exposure factor and Sun.</param>
    public static void Write(TextWriter writer, string head, IReadOnlyList<SpacecraftState> states)
    {
        string[] names =
        [
            .. SpacecraftState.NumberNames, .. states.Any(state => state.Motion is not null) ? CameraMotion.NumberNames : [],
        ];
        bool hasNoise = states.Any(state => state.Noise is not null);
        bool hasSun = states.Any(state => state.SunPositionBodyFixed is not null);
        bool hasExposure = states.Any(state => state.ExposureFactor is not null);
        string[] named =
        [
            .. hasSun ? BatchNames.Sun : [], .. hasNoise ? (string[])[BatchNames.Noise] : [],
            .. hasExposure ? (string[])[BatchNames.Exposure] : [],
        ];
        writer.WriteLine($"# {head}");
        writer.WriteLine(named.Length > 0 ? string.Join(',', [.. names, .. named]) : $"# {string.Join(' ', names)}");
        foreach (SpacecraftState state in states)
        {
            IEnumerable<string> numbers =
            [
                .. state.ToNumbers().Concat(state.SunPositionBodyFixed is { } sun ? [sun.X, sun.Y, sun.Z] : [])
                    .Select(number => number.ToString("R", CultureInfo.InvariantCulture)),
                .. state.Noise is { } noise ? (string[])[NoiseSeedText.Of(noise)] : [],
                .. state.ExposureFactor is { } factor ? (string[])[factor.ToString("R", CultureInfo.InvariantCulture)] : [],
            ];
            writer.WriteLine(string.Join(named.Length > 0 ? ',' : ' ', numbers));
        }
    }
}
