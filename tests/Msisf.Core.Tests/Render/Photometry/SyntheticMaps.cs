using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Tests.Render.Photometry;

/// <summary>Maps of the whole Moon from functions, with their levels.</summary>
internal static class SyntheticMaps
{
    public static MapExtent WholeMoon { get; } = new(-Math.PI, Math.PI / 2.0, 2.0 * Math.PI, Math.PI);

    /// <summary>A map whose reflectance is 1e-4 times the code.</summary>
    /// <param name="width">Pixels; the height is half of it, rounded up.</param>
    /// <param name="codeOf">Code of a column and row; 0 for no data.</param>
    public static AlbedoMap Of(int width, Func<int, int, int> codeOf) => Of(width, (width + 1) / 2, WholeMoon, codeOf);

    public static AlbedoMap Of(int width, int height, MapExtent extent, Func<int, int, int> codeOf)
    {
        float[] values = new float[width * height];
        for (int i = 0; i < values.Length; i++)
        {
            int code = codeOf(i % width, i / width);
            values[i] = code == 0 ? float.NaN : code;
        }

        List<AlbedoMapLevel> levels = [Level(width, height, values)];
        while (width > 1 || height > 1)
        {
            (width, height, values) = Reduced(width, height, extent, values);
            levels.Add(Level(width, height, values));
        }

        return new AlbedoMap(levels, extent, 0.0, 1e-4, new ReferenceGeometry(60.0, 0.0, 60.0));
    }

    public static (int Width, int Height, float[] Values) Reduced(int width, int height, MapExtent extent, float[] values)
    {
        List<float> coarse = [];
        MapReducer reducer = new(width, height, extent, (row, finished) =>
        {
            Xunit.Assert.Equal(coarse.Count, row * finished.Length);
            coarse.AddRange(finished);
        });
        for (int row = 0; row < height; row++)
        {
            reducer.Add(row, values.AsSpan(row * width, width));
        }

        return (reducer.Width, reducer.Height, [.. coarse]);
    }

    private static AlbedoMapLevel Level(int width, int height, float[] values) =>
        new(width, height, values.Select(value => float.IsNaN(value) ? (ushort)0 : (ushort)Math.Round(value)).ToArray());
}
