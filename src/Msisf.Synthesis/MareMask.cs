using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The mare fraction of the ground, from a model's mean heights over cells of 1 degree: maria are low ground of the near side. The
/// fraction is 1 below -1600 m and 0 above -900 m; it decreases to 0 towards the limb, so that the floor of the South Pole-Aitken basin
/// counts as highlands.
/// </summary>
/// <remarks>A rule of thumb, not a geological map: all low ground of the near side counts as mare.</remarks>
internal sealed class MareMask
{
    private const int Rows = 180;
    private const int Columns = 360;
    private const int LinesPerDegree = 4; // enough for a mean over 30 km; a fine base is not read whole
    private const double FullBelow = -1600.0; // m over the reference radius
    private const double NoneAbove = -900.0;
    private const double FullNearSide = 0.30; // cosine of the angle from the sub-Earth point
    private const double NoneNearSide = 0.15;

    private readonly float[] _cells = new float[Rows * Columns];

    /// <summary>Measures a model.</summary>
    /// <param name="model">Any resolution.</param>
    /// <param name="cancellation">Stops the reading.</param>
    public MareMask(IGlobalGrid model, CancellationToken cancellation)
    {
        int resolution = model.PixelsPerDegree;
        int lines = Math.Min(LinesPerDegree, resolution);
        double[] radii = new double[Columns * resolution];
        double[] sums = new double[Columns];
        for (int row = 0; row < Rows; row++)
        {
            cancellation.ThrowIfCancellationRequested();
            Array.Clear(sums);
            for (int line = 0; line < lines; line++)
            {
                model.ReadRadii((row * resolution) + (((2 * line) + 1) * resolution / (2 * lines)), 0, radii);
                for (int sample = 0; sample < radii.Length; sample++)
                {
                    sums[sample / resolution] += radii[sample];
                }
            }

            for (int column = 0; column < Columns; column++)
            {
                double height = (sums[column] / (lines * resolution)) - MoonConstants.ReferenceRadius;
                _cells[(row * Columns) + column] = (float)FractionOf(height, NearSide(row, column));
            }
        }
    }

    /// <summary>Mare fraction at a place, 0 (highlands) to 1 (mare).</summary>
    /// <param name="latitudeDegrees">[-90, 90], or beyond on mirror lines.</param>
    /// <param name="longitudeDegrees">[0, 360).</param>
    public double At(double latitudeDegrees, double longitudeDegrees)
    {
        (int row, double down) = Split(89.5 - latitudeDegrees);
        (int column, double right) = Split(longitudeDegrees - 0.5);
        double north = Blend(Cell(row, column), Cell(row, column + 1), right);
        double south = Blend(Cell(row + 1, column), Cell(row + 1, column + 1), right);
        return Blend(north, south, down);
    }

    /// <summary>The mare fractions of a frame's samples.</summary>
    /// <param name="frame">The block.</param>
    /// <param name="fractions">Filled, as the frame's samples.</param>
    public void Fill(MapFrame frame, Span<float> fractions)
    {
        if (SameAround(frame) is { } same)
        {
            fractions.Fill((float)same);
            return;
        }

        for (int i = 0; i < fractions.Length; i++)
        {
            fractions[i] = (float)At(frame.Latitudes[i], frame.Longitudes[i]);
        }
    }

    /// <summary>The mare fraction of all cells between which a frame's samples lie, if it is the same and none is beyond a pole.</summary>
    private double? SameAround(MapFrame frame)
    {
        (double south, double north, double west, double width) = frame.Around();
        int firstRow = Split(89.5 - north).Whole;
        int lastRow = Split(89.5 - south).Whole + 1;
        int firstColumn = Split(west - 0.5).Whole;
        int lastColumn = Split(west + width - 0.5).Whole + 1;
        if (firstRow < 0 || lastRow >= Rows || lastColumn - firstColumn >= Columns)
        {
            return null;
        }

        double same = Cell(firstRow, ((firstColumn % Columns) + Columns) % Columns);
        for (int row = firstRow; row <= lastRow; row++)
        {
            for (int column = firstColumn; column <= lastColumn; column++)
            {
                if (Cell(row, ((column % Columns) + Columns) % Columns) != same)
                {
                    return null;
                }
            }
        }

        return same;
    }

    /// <summary>The mare fractions along one line of a frame.</summary>
    /// <param name="frame">The block.</param>
    /// <param name="line">Line of the block.</param>
    /// <param name="fractions">Filled for every column of the stride.</param>
    public void FillLine(TileFrame frame, int line, Span<float> fractions)
    {
        (int row, double down) = Split(89.5 - frame.LatitudeDegrees(line));
        Span<float> cellsOfLine = stackalloc float[Columns];
        for (int column = 0; column < Columns; column++)
        {
            cellsOfLine[column] = (float)Blend(Cell(row, column), Cell(row + 1, column), down);
        }

        int around = Columns * frame.PixelsPerDegree;
        int sample = ((frame.FirstSample % around) + around) % around;
        float step = 1.0f / frame.PixelsPerDegree;
        for (int i = 0; i < fractions.Length; i++)
        {
            // Cell centres are at half degrees: the cell west of the sample, and the distance from its centre.
            int fromCentre = (2 * sample) + 1 - frame.PixelsPerDegree + (2 * around);
            int cell = fromCentre / (2 * frame.PixelsPerDegree);
            float right = (fromCentre - (2 * frame.PixelsPerDegree * cell)) * 0.5f * step;
            float west = cellsOfLine[cell % Columns];
            fractions[i] = west + (right * (cellsOfLine[(cell + 1) % Columns] - west));
            sample = sample + 1 == around ? 0 : sample + 1;
        }
    }

    /// <summary>The mare fraction that the rule gives for ground at a height.</summary>
    /// <param name="height">m over the reference radius.</param>
    /// <param name="nearSide">Cosine of the angle from the sub-Earth point (latitude 0, longitude 0).</param>
    public static double FractionOf(double height, double nearSide) =>
        SmoothStep((NoneAbove - height) / (NoneAbove - FullBelow)) * SmoothStep((nearSide - NoneNearSide) / (FullNearSide - NoneNearSide));

    private static double NearSide(int row, int column) =>
        PortableMath.SinCosDegrees(89.5 - row).Cos * PortableMath.SinCosDegrees(column + 0.5).Cos;

    private static double SmoothStep(double t)
    {
        t = Math.Clamp(t, 0.0, 1.0);
        return t * t * (3.0 - (2.0 * t));
    }

    private static (int Whole, double Fraction) Split(double position)
    {
        double whole = Math.Floor(position);
        return ((int)whole, position - whole);
    }

    private static double Blend(double a, double b, double weightOfB) => a + (weightOfB * (b - a));

    // Beyond a pole a row continues along the opposite meridian.
    private double Cell(int row, int column)
    {
        if (row is < 0 or >= Rows)
        {
            row = row < 0 ? -1 - row : (2 * Rows) - 1 - row;
            column += Columns / 2;
        }

        return _cells[(row * Columns) + ((column + Columns) % Columns)];
    }
}
