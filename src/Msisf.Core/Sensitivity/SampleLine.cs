using Msisf.Core.Render;

namespace Msisf.Core.Sensitivity;

/// <summary>One row of samples; one object is used for many.</summary>
/// <param name="samples">The samples as an image, with ground truth.</param>
internal sealed class SampleLine(IGroundTruth samples)
{
    private readonly double _imagePlaneDistance = samples.Camera.BandAt(1.0).Camera.ImagePlaneDistance;
    private readonly int[] _indices = new int[samples.Camera.Width];
    private int _row;

    /// <summary>The samples that show the surface.</summary>
    public TruthRow Truth { get; } = new();

    /// <summary>I/F of each sample.</summary>
    public ReadOnlySpan<double> Light => samples.RadianceFactorsOf(_row);

    /// <summary>1/m: one over the depth of each sample along the optical axis; 0 for the sky.</summary>
    public double[] Nearness { get; } = new double[samples.Camera.Width];

    /// <summary>The part of the Sun that each sample sees, 0 to 1; 0 for the sky.</summary>
    public double[] Visible { get; } = new double[samples.Camera.Width];

    /// <summary>Reads a row, from 0.</summary>
    public void Read(int row)
    {
        _row = row;
        samples.ReadRow(row + 1, Truth);
        Array.Clear(Nearness);
        Array.Clear(Visible);
        Array.Fill(_indices, -1);
        for (int i = 0; i < Truth.Points.Count; i++)
        {
            int column = Truth.Points.Columns[i];
            _indices[column] = i;
            Nearness[column] = 1.0 / (Truth.Points.Parameters[i] * _imagePlaneDistance);
            Visible[column] = Truth.Lights[i].VisibleFraction;
        }
    }

    /// <summary>Which of <see cref="Truth"/> a sample is; -1 for the sky.</summary>
    public int IndexOf(int column) => _indices[column];
}
