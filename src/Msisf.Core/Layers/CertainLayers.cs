using System.Numerics;
using Msisf.Core.Certainty;

namespace Msisf.Core.Layers;

/// <summary>The layers of an image's bounds, which are written into a file of their own.</summary>
public static class CertainLayers
{
    /// <summary>Their names.</summary>
    public static IReadOnlyList<string> Names { get; } = ["certain-low", "certain-high", "certain-state"];

    /// <summary>The layers of some bounds.</summary>
    public static LayerSet Of(CertainImage image)
    {
        byte[] states = image.StateNumbers;
        return LayerSet.Of(
        [
            new Layer(
                Names[0], LayerType.Real64, string.Empty, "The least I/F that the pixel can have within the limits of --certify.",
                (row, _, values) => Copy(row, image.Low, image.Width, values)) { CoversImage = true },
            new Layer(
                Names[1], LayerType.Real64, string.Empty, "The greatest I/F that the pixel can have within the limits of --certify.",
                (row, _, values) => Copy(row, image.High, image.Width, values)) { CoversImage = true },
            new Layer(
                Names[2], LayerType.Unsigned8, string.Empty,
                "0 no surface, 1 lit by the whole Sun, 2 dark, all three within the limits of --certify; 3 undecided.",
                (row, _, values) => Copy(row, states, image.Width, values)) { CoversImage = true },
        ]);
    }

    private static void Copy<T>(LayerRow row, T[] image, int width, double[] values)
        where T : INumberBase<T>
    {
        for (int column = 0; column < width; column++)
        {
            values[column] = double.CreateChecked(image[(row.Row * width) + column]);
        }
    }
}
