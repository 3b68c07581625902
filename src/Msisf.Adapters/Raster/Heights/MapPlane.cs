using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The pixels of a map as a plane onto which PROJ brings places of the Moon. Columns and rows count from the centre of the first pixel.
/// Not safe for several threads.
/// </summary>
internal sealed class MapPlane : IDisposable
{
    /// <summary>Projections whose rows are parallels and whose columns are meridians, evenly spaced.</summary>
    private static readonly HashSet<string> Cylindrical =
        ["longlat", "eqc", "cea", "merc", "webmerc", "mill", "gall", "cc", "comill", "patterson", "tobmerc", "compmill"];

    private readonly (double Left, double Top, double Across, double Down) _map;
    private readonly GdalTransformation _toMap;
    private readonly GdalTransformation _toDegrees;
    private readonly double _turn = double.NaN;
    private readonly double _middleColumn;

    private MapPlane(
        GdalImage image, double[] transform, ProjText proj, GdalTransformation toMap, GdalTransformation toDegrees)
    {
        (_toMap, _toDegrees, Radius) = (toMap, toDegrees, proj.Radius!.Value);
        _map = (transform[0], transform[3], transform[1], -transform[5]);
        (Width, Height, MiddleLongitude) = (image.Width, image.Height, proj.MiddleLongitude);
        if (!Cylindrical.Contains(proj.Name))
        {
            return;
        }

        (double[] x, double[] y) = ([MiddleLongitude - 45.0, MiddleLongitude, MiddleLongitude + 45.0], new double[3]);
        toMap.Transform(x, y);
        _turn = 4.0 * (x[2] - x[0]) / _map.Across;
        _middleColumn = ((x[1] - _map.Left) / _map.Across) - 0.5;
        IsRing = Math.Round(_turn) >= 2.0 && Math.Round(_turn) <= image.Width;
        if (IsRing)
        {
            Width = (int)Math.Round(_turn); // a last column that repeats the first one is left out
        }
    }

    /// <summary>m: radius of the sphere.</summary>
    public double Radius { get; }

    /// <summary>Pixels of a row.</summary>
    public int Width { get; }

    /// <summary>Number of rows.</summary>
    public int Height { get; }

    /// <summary>deg: the longitude from which map coordinates count.</summary>
    public double MiddleLongitude { get; }

    /// <summary>Whether rows are parallels and columns are meridians.</summary>
    public bool IsCylindrical => !double.IsNaN(_turn);

    /// <summary>Whether the last pixel of a row lies beside the first one.</summary>
    public bool IsRing { get; }

    /// <summary>deg: width of a column of a cylindrical projection.</summary>
    public double ColumnDegrees => 360.0 / _turn;

    /// <summary>The plane of a map.</summary>
    /// <returns>Null if PROJ knows no way to it.</returns>
    public static MapPlane? Of(GdalImage image, ProjText proj)
    {
        string degrees = Invariant($"+proj=longlat +R={proj.Radius!.Value:R} +no_defs");
        GdalTransformation? toMap = image.Transformation(degrees, proj.ForProj);
        GdalTransformation? toDegrees = image.Transformation(proj.ForProj, degrees);
        if (toMap is not null && toDegrees is not null)
        {
            return new MapPlane(image, image.GeoTransform()!, proj, toMap, toDegrees);
        }

        toMap?.Dispose();
        toDegrees?.Dispose();
        return null;
    }

    /// <summary>A column of a map that goes all around, whatever turn it is counted in; of another map itself.</summary>
    public int ColumnAround(int column) => IsRing ? ((column % Width) + Width) % Width : column;

    /// <summary>Brings longitudes and latitudes in degrees to columns and rows, in place; NaN for nowhere.</summary>
    public void ToPixels(Span<double> columns, Span<double> rows)
    {
        _toMap.Transform(columns, rows);
        for (int i = 0; i < columns.Length; i++)
        {
            columns[i] = ((columns[i] - _map.Left) / _map.Across) - 0.5;
            rows[i] = ((_map.Top - rows[i]) / _map.Down) - 0.5;
        }

        if (!IsCylindrical)
        {
            return;
        }

        // Places of a part lie together, also where the columns' numbers begin anew.
        double near = IsRing && !double.IsNaN(columns[columns.Length / 2]) ? columns[columns.Length / 2] : 0.5 * (Width - 1);
        for (int i = 0; i < columns.Length; i++)
        {
            columns[i] -= _turn * Math.Round((columns[i] - near) / _turn);
        }
    }

    /// <summary>Brings longitudes to columns and latitudes to rows of a cylindrical projection, in degrees and in place.</summary>
    /// <param name="columns">Increasing, over 360 degrees at most.</param>
    public void ToLattice(Span<double> columns, Span<double> rows)
    {
        Span<double> x = new double[rows.Length];
        x.Fill(MiddleLongitude);
        _toMap.Transform(x, rows);
        foreach (ref double row in rows)
        {
            row = ((_map.Top - row) / _map.Down) - 0.5;
        }

        foreach (ref double column in columns)
        {
            column = _middleColumn + ((column - MiddleLongitude) / 360.0 * _turn);
        }

        double turned = _turn * Math.Round((columns[columns.Length / 2] - (0.5 * (Width - 1))) / _turn);
        foreach (ref double column in columns)
        {
            column -= turned;
        }
    }

    /// <summary>Longitudes and latitudes of places among the pixels, deg; NaN for nowhere.</summary>
    public (double[] Longitudes, double[] Latitudes) ToDegrees(IReadOnlyList<(double Column, double Row)> places)
    {
        double[] x = [.. places.Select(place => _map.Left + ((place.Column + 0.5) * _map.Across))];
        double[] y = [.. places.Select(place => _map.Top - ((place.Row + 0.5) * _map.Down))];
        _toDegrees.Transform(x, y);
        return (x, y);
    }

    /// <summary>Forgets PROJ's ways.</summary>
    public void Dispose()
    {
        _toMap.Dispose();
        _toDegrees.Dispose();
    }
}
