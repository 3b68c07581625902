namespace Msisf.Core.Sensitivity;

/// <summary>
/// The mean radiance factor I/F over each pixel and its partial derivatives, by rows from the top. Immutable but for its arrays.
/// </summary>
public sealed class SensitivityField
{
    internal SensitivityField(int width, int height)
    {
        (Width, Height) = (width, height);
        Planes = [.. Parameter.All.Select(_ => new double[width * height])];
    }

    private SensitivityField(int width, int height, double[][] planes) => (Width, Height, Planes) = (width, height, planes);

    /// <summary>px.</summary>
    public int Width { get; }

    /// <summary>px.</summary>
    public int Height { get; }

    /// <summary>A plane for each of <see cref="Parameter.All"/>.</summary>
    internal double[][] Planes { get; }

    /// <summary>The derivative by a parameter, per its unit.</summary>
    public double[] Of(Parameter parameter) => Planes[IndexOf(parameter)];

    /// <summary>The mean itself: the derivative by a scale of the brightness.</summary>
    public double[] Mean => Planes[^1];

    /// <summary>The same with each plane replaced by another, e.g. by its electrons.</summary>
    internal SensitivityField Map(int width, int height, Func<double[], double[]> change) =>
        new(width, height, [.. Planes.Select(change)]);

    private static int IndexOf(Parameter parameter)
    {
        for (int i = 0; i < Parameter.All.Count; i++)
        {
            if (Parameter.All[i] == parameter)
            {
                return i;
            }
        }

        throw new ArgumentOutOfRangeException(nameof(parameter), parameter, "There is no such parameter.");
    }
}
