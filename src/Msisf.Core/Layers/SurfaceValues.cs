using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;

namespace Msisf.Core.Layers;

/// <summary>Layer values of the positions and shape of the surface at a row's pixels.</summary>
internal static class SurfaceValues
{
    /// <summary>m, along the ray; from the ray's parameter, so it keeps its digits when the ground is near.</summary>
    public static void Range(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<double> lengths = row.SightLengths;
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = row.Parameters[i] * lengths[i];
        }
    }

    /// <summary>m, along the optical axis: the ray's direction is one image plane distance long on it.</summary>
    public static void Depth(LayerRow row, int plane, double[] values)
    {
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = row.Parameters[i] * row.AxisLength;
        }
    }

    /// <summary>m: see <see cref="Camera.FrameCamera.PixelSide(Camera.Ray, double)"/>.</summary>
    public static void PixelScale(LayerRow row, int plane, double[] values)
    {
        VectorRow sight = row.Sight;
        double[] lengths = row.SightLengths;
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = row.Camera.PixelSide(row.AxisLength, sight[i], lengths[i], row.Parameters[i]);
        }
    }

    public static void Position(LayerRow row, int plane, double[] values) => Copy(row.Points, plane, row.Count, values);

    public static void Normal(LayerRow row, int plane, double[] values) => Copy(row.Normals, plane, row.Count, values);

    /// <summary>As <see cref="Terrain.SelenographicPoint.Below"/> has it.</summary>
    public static void Latitude(LayerRow row, int plane, double[] values)
    {
        VectorRow points = row.Points;
        LaneHypot.AxisDistances(points, row.Count, values);
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = double.RadiansToDegrees(Trigonometry.Atan2(points.Z[i], values[i]));
        }
    }

    /// <summary>As <see cref="Terrain.SelenographicPoint.Below"/> has it.</summary>
    public static void Longitude(LayerRow row, int plane, double[] values)
    {
        VectorRow points = row.Points;
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = double.RadiansToDegrees(AngleReduction.FullTurnOfHalf(Trigonometry.Atan2(points.Y[i], points.X[i])));
        }
    }

    public static void Height(LayerRow row, int plane, double[] values)
    {
        double[] radii = row.Radii;
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = radii[i] - row.ReferenceRadius;
        }
    }

    public static void Cell(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<FacetId> facets = row.Facets;
        for (int i = 0; i < facets.Length; i++)
        {
            values[i] = plane switch
            {
                0 => facets[i].Line,
                1 => facets[i].Sample,
                _ => facets[i].Part,
            };
        }
    }

    /// <summary>
    /// <see cref="TileId.Number"/> of the tile that the cell belongs to (docs/pattern-format.md); there are none on a polar map.
    /// </summary>
    public static void Tile(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<FacetId> facets = row.Facets;
        for (int i = 0; i < facets.Length; i++)
        {
            values[i] = row.MeshPixelsPerDegree is { } pixelsPerDegree ? TileId.Holding(facets[i], pixelsPerDegree).Number : double.NaN;
        }
    }

    /// <summary>Model and <see cref="FacetSource"/> of the facet.</summary>
    public static void Source(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<FacetId> facets = row.Facets;
        for (int i = 0; i < facets.Length; i++)
        {
            (int model, FacetSource source) = row.Sources?.Of(facets[i]) ?? (0, FacetSource.Measured);
            values[i] = plane == 0 ? model : (int)source;
        }
    }

    /// <summary>1 also without invented ground.</summary>
    public static void Rays(LayerRow row, int plane, double[] values)
    {
        int count = row.Count;
        values.AsSpan(0, count).Fill(1.0);
        row.Sources?.Brightness?.Scale(
            row.Points.X.AsSpan(0, count), row.Points.Y.AsSpan(0, count), row.Points.Z.AsSpan(0, count), values.AsSpan(0, count));
    }

    /// <summary>0 also without a catalogue.</summary>
    public static void CraterNumber(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<int> numbers = row.CraterNumbers;
        ReadOnlySpan<int> columns = row.Columns;
        for (int i = 0; i < columns.Length; i++)
        {
            values[i] = numbers.IsEmpty ? 0.0 : numbers[columns[i]];
        }
    }

    /// <summary>0 also without a sky.</summary>
    public static void ObjectNumber(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<int> numbers = row.ObjectNumbers;
        values.AsSpan(0, row.Camera.Width).Clear();
        for (int i = 0; i < numbers.Length; i++)
        {
            values[i] = numbers[i];
        }
    }

    private static void Copy(VectorRow vectors, int plane, int count, double[] values)
    {
        double[] component = plane switch
        {
            0 => vectors.X,
            1 => vectors.Y,
            _ => vectors.Z,
        };
        component.AsSpan(0, count).CopyTo(values);
    }
}

/// <summary>Layer values of the surface's inclination against the sphere.</summary>
internal static class SlopeValues
{
    /// <summary>Pixels that are computed at once; a multiple of eight.</summary>
    private const int Block = 256;

    /// <summary>Degrees between the normal and the radius.</summary>
    public static void Slope(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindExactAngles(row.Normals, row.NormalLengths, row.Points, row.Radii, row.Count, values);

    /// <summary>Degrees from north over east to the direction in which the ground falls.</summary>
    public static void Aspect(LayerRow row, int plane, double[] values)
    {
        Span<double> toNorth = stackalloc double[Block];
        Span<double> eastLengths = stackalloc double[Block];
        Span<double> falls = stackalloc double[Block];
        for (int first = 0; first < row.Count; first += Block)
        {
            int count = Math.Min(Block, row.Count - first);
            FindFall(row, first, count, values, toNorth, eastLengths, falls);
            for (int i = 0; i < count; i++)
            {
                // The polar axis has no north, and level ground does not fall.
                bool isDefined = eastLengths[i] >= Tolerances.ParallelSine && falls[i] >= Tolerances.LevelSlope * eastLengths[i];
                values[first + i] = isDefined ? Azimuth(values[first + i], toNorth[i]) : double.NaN;
            }
        }
    }

    /// <summary>Degrees between the radius and the direction to the Sun.</summary>
    public static void SphereIncidence(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindExactAngles(row.Points, row.Radii, row.ToLight, row.LightDistances, row.Count, values);

    /// <summary>Finds the horizontal parts of the outward normals, which lead downhill.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first rows would otherwise be computed with unoptimised vectors
    private static void FindFall(
        LayerRow row, int first, int count, double[] toEast, Span<double> toNorth, Span<double> eastLengths, Span<double> falls)
    {
        double[] radii = row.Radii;
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            LaneVector up = LaneVector.Load(row.Points, first + i) / LaneVector.Load(radii, first + i);
            LaneVector east = LaneVector.Cross(LaneVector.All(Vector3D.UnitZ), up);
            LaneVector north = LaneVector.Cross(up, east);
            LaneVector normal = LaneVector.Load(row.Normals, first + i);
            Vector512<double> alongEast = LaneVector.Dot(normal, east);
            Vector512<double> alongNorth = LaneVector.Dot(normal, north);
            LaneVector.Store(alongEast, toEast, first + i);
            alongNorth.CopyTo(toNorth[i..]);
            LaneHypot.Of(LaneHypot.Of(east.X, east.Y), east.Z).CopyTo(eastLengths[i..]);
            LaneHypot.Of(alongEast, alongNorth).CopyTo(falls[i..]);
        }
    }

    private static double Azimuth(double toEast, double toNorth)
    {
        double azimuth = double.RadiansToDegrees(Trigonometry.Atan2(toEast, toNorth));
        return azimuth < 0.0 ? Math.Min(azimuth + 360.0, Math.BitDecrement(360.0)) : azimuth;
    }
}
