using System.Numerics;
using Msisf.Core.Navigation;

namespace Msisf.Core.Layers;

/// <summary>The layers of a flow, which are written into files of their own.</summary>
public static class FlowLayers
{
    /// <summary>The layers of the flow to another frame.</summary>
    public static LayerSet OfFlow(FlowField flow) => LayerSet.Of(
    [
        new Layer(
            "flow", LayerType.Real64, "pixel",
            "Where the surface point of the pixel's centre lies in the other frame, from the pixel's centre. Undefined behind that camera.",
            (row, plane, values) => Copy(row, plane == 0 ? flow.Right : flow.Down, flow.Width, values),
            "x", "y"),
        new Layer(
            "flow-class", LayerType.Unsigned8, string.Empty,
            "0 no surface, 1 seen in the other frame, 2 hidden there by terrain or by its own facet, 3 outside the other image.",
            (row, _, values) => Copy(row, flow.Classes, flow.Width, values)),
        new Layer(
            "flow-light", LayerType.Unsigned8, string.Empty,
            "0 no surface, 1 lit in both, 2 dark in both, 3 dark in one by a cast shadow, 4 dark in one by its slope.",
            (row, _, values) => Copy(row, flow.Lights, flow.Width, values)),
    ]);

    /// <summary>The layers of the flow to a camera to the right of the frame's.</summary>
    public static LayerSet OfStereo(FlowField flow) => LayerSet.Of(
    [
        new Layer(
            "disparity", LayerType.Real64, "pixel",
            "How far left of the pixel's centre its surface point lies in the right image. Undefined behind the right camera.",
            (row, _, values) =>
            {
                Copy(row, flow.Right, flow.Width, values);
                for (int i = 0; i < row.Count; i++)
                {
                    values[i] = -values[i];
                }
            }),
        new Layer(
            "disparity-class", LayerType.Unsigned8, string.Empty,
            "0 no surface, 1 seen in the right image, 2 hidden there by terrain or by its own facet, 3 outside the right image.",
            (row, _, values) => Copy(row, flow.Classes, flow.Width, values)),
    ]);

    private static void Copy<T>(LayerRow row, T[] image, int width, double[] values)
        where T : INumberBase<T>
    {
        ReadOnlySpan<int> columns = row.Columns;
        for (int i = 0; i < columns.Length; i++)
        {
            values[i] = double.CreateChecked(image[(row.Row * width) + columns[i]]);
        }
    }
}
