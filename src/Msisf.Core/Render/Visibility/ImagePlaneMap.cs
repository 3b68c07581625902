using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// A linear map from the ideal image plane (tangents to the right and down) to columns and rows, counted from 0. For a pinhole it is the
/// camera matrix; for some pixels of a lens it puts every sample near its pixel.
/// </summary>
internal readonly record struct ImagePlaneMap(
    double ColumnPerRight, double ColumnPerDown, double Column0, double RowPerRight, double RowPerDown, double Row0)
{
    /// <summary>The map of a pinhole.</summary>
    /// <param name="model">The camera; its lens is left out.</param>
    public static ImagePlaneMap Of(CameraModel model) => new(
        model.FocalX, model.Skew, model.PrincipalX - 1.0, 0.0, model.FocalY, model.PrincipalY - 1.0);

    /// <summary>Column of a point of the ideal plane.</summary>
    public double Column(double right, double down) => (ColumnPerRight * right) + (ColumnPerDown * down) + Column0;

    /// <summary>Row of a point of the ideal plane.</summary>
    public double Row(double right, double down) => (RowPerRight * right) + (RowPerDown * down) + Row0;

    /// <summary>Columns and rows of points of the ideal plane, with the bits of <see cref="Column"/> and <see cref="Row"/>.</summary>
    public void Apply(ReadOnlySpan<double> right, ReadOnlySpan<double> down, Span<double> columns, Span<double> rows)
    {
        int i = 0;
        for (; i <= columns.Length - Vector512<double>.Count; i += Vector512<double>.Count)
        {
            (Vector512<double> x, Vector512<double> y) = Apply(Vector512.Create(right[i..]), Vector512.Create(down[i..]));
            x.CopyTo(columns[i..]);
            y.CopyTo(rows[i..]);
        }

        for (; i < columns.Length; i++)
        {
            (columns[i], rows[i]) = (Column(right[i], down[i]), Row(right[i], down[i]));
        }
    }

    /// <summary>The same for eight points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (Vector512<double> Column, Vector512<double> Row) Apply(Vector512<double> right, Vector512<double> down) => (
        (ColumnPerRight * right) + (ColumnPerDown * down) + Vector512.Create(Column0),
        (RowPerRight * right) + (RowPerDown * down) + Vector512.Create(Row0));

    /// <summary>The point of the ideal plane at a column and row.</summary>
    /// <remarks>The inverse of a 2 x 2 matrix is two lines; MathNet's is an object and takes 6 us.</remarks>
    public (double Right, double Down) Inverse(double column, double row)
    {
        (double x, double y) = (column - Column0, row - Row0);
        double determinant = (ColumnPerRight * RowPerDown) - (ColumnPerDown * RowPerRight);
        return (((RowPerDown * x) - (ColumnPerDown * y)) / determinant, ((ColumnPerRight * y) - (RowPerRight * x)) / determinant);
    }
}
