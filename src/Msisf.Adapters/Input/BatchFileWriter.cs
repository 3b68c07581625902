using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.Adapters.Input;

/// <summary>Writes batch files (thesis section 6.3.2). <see cref="BatchFileReader"/> reads the same states back, bit for bit.</summary>
public static class BatchFileWriter
{
    /// <summary>Writes all states.</summary>
    /// <param name="writer">Gets the text, about 160 bytes a state.</param>
    /// <param name="head">A comment of one line at the top, without control characters.</param>
    /// <param name="states">In the order of their lines.</param>
    public static void Write(TextWriter writer, string head, IReadOnlyList<SpacecraftState> states)
    {
        IEnumerable<string> names = states.Any(state => state.Motion is not null)
            ? SpacecraftState.NumberNames.Concat(CameraMotion.NumberNames)
            : SpacecraftState.NumberNames;
        writer.WriteLine($"# {head}");
        writer.WriteLine($"# {string.Join(' ', names)}");
        foreach (SpacecraftState state in states)
        {
            writer.WriteLine(string.Join(' ', state.ToNumbers().Select(number => number.ToString("R", CultureInfo.InvariantCulture))));
        }
    }
}
