using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shading;

/// <summary>Computes the radiance factors of a row's lit pixels. Keeps buffers, so each thread needs its own object.</summary>
internal sealed class RowReflection(SurfaceModel surface)
{
    /// <summary>Most pixels of a row face the light if no more than the row's length over this do not.</summary>
    private const int MostOver = 8;

    private readonly AlbedoSampler _albedo = new();
    private double[] _ofLaw = [];
    private double[] _cosines = [];
    private double[] _fractions = [];
    private readonly SurfaceRow _row = new();
    private readonly SmoothNormals _normals = new(surface);

    /// <summary>The pixels.</summary>
    public SunlitPoints Points { get; } = new();

    /// <summary>
    /// Takes the pixels of a row that face the light, with their facets' normals and without weights; if most of them do, all pixels: the
    /// law is quicker than copying.
    /// </summary>
    /// <param name="cosIncidence">Cosines of the incidence angles of its pixels.</param>
    /// <param name="width">Pixels of a whole row.</param>
    public void TakeFacing(SurfaceRow row, double[] cosIncidence, int width) =>
        Take(row, cosIncidence.AsSpan(0, row.Count), cosIncidence, width, unlit: row.Count / MostOver);

    /// <summary>Computes by what the maps multiply the law's radiance factors at the points of a row that face the light.</summary>
    /// <param name="row">The points.</param>
    /// <param name="cosIncidence">Cosines of their incidence angles.</param>
    /// <param name="minCosine">Only points with a greater cosine face the light.</param>
    /// <param name="options">The maps.</param>
    /// <param name="scales">Receives it, by column; undefined where a point faces away.</param>
    public void FindScales(
        FrameCamera camera, SurfaceRow row, double[] cosIncidence, double minCosine, NativeRenderOptions options, Span<double> scales)
    {
        Take(row, cosIncidence.AsSpan(0, row.Count), cosIncidence, scales.Length, unlit: row.Count / MostOver, minCosine);
        FindScales(camera, options);
        for (int i = 0; i < Points.Count; i++)
        {
            scales[Points.Columns[i]] = Points.Factors[i];
        }
    }

    /// <summary>Collects the sunlit pixels of a row, with the normals that shade them.</summary>
    /// <param name="visible">The surface points that the pixels show.</param>
    /// <param name="row">Index of the row, from 0.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="sunlight">The light on each pixel.</param>
    /// <param name="normals">Kind of normals.</param>
    public void TakeLit(
        ISurfaceRows visible, int row, SceneLight light, PixelSunlight sunlight, NormalModel normals)
    {
        ReadOnlySpan<double> fractions = Read(visible, row, sunlight);
        Take(_row, fractions, _cosines, visible.Width, unlit: 0);
        int lit = 0;
        foreach (double fraction in fractions)
        {
            if (fraction > 0.0)
            {
                Points.Weights[lit++] = fraction;
            }
        }

        // A smooth normal can point away from the light where the facet's normal does not, and a facet can be seen edge-on: the laws
        // give 0 there.
        if (normals == NormalModel.Smooth)
        {
            _normals.Smooth(Points, visible, row + 1, light.PositionBodyFixed);
        }
    }

    /// <summary>Reads the points of a row with the cosines of their incidence angles, and returns the visible fractions.</summary>
    private ReadOnlySpan<double> Read(ISurfaceRows visible, int row, PixelSunlight sunlight)
    {
        visible.Read(row + 1, _row);
        if (_cosines.Length < _row.Count + SurfaceRow.Padding)
        {
            _cosines = new double[visible.Width + SurfaceRow.Padding];
            _fractions = new double[visible.Width + SurfaceRow.Padding];
        }

        Span<double> fractions = _fractions.AsSpan(0, _row.Count);
        sunlight.Read(row * visible.Width, _row.Columns.AsSpan(0, _row.Count), _cosines, fractions);
        return fractions;
    }

    /// <summary>Takes the pixels of a row with light, or all of them.</summary>
    /// <param name="light">Above <paramref name="least"/> for pixels with light.</param>
    /// <param name="unlit">Maximum number of pixels without light of a row that is taken as a whole.</param>
    private void Take(
        SurfaceRow row, ReadOnlySpan<double> light, double[] cosIncidence, int width, int unlit, double least = 0.0)
    {
        Points.Clear(width);
        int dark = 0;
        foreach (double ofPixel in light)
        {
            dark += ofPixel > least ? 0 : 1;
        }

        if (dark <= unlit)
        {
            Points.Share(row, cosIncidence);
            return;
        }

        for (int i = 0; i < light.Length; i++)
        {
            int first = i;
            while (i < light.Length && light[i] > least)
            {
                i++;
            }

            if (i > first)
            {
                Points.AddRun(row, cosIncidence, first, i - first);
            }
        }
    }

    /// <summary>
    /// The smooth normal at a point, or the facet's normal if the smooth one points away from the camera, as it can at the limb:
    /// reflectance laws are undefined there.
    /// </summary>
    /// <param name="facetNormal">Its own normal, length 1, body-fixed.</param>
    /// <param name="point">The point on it, m, body-fixed.</param>
    /// <param name="camera">The camera's position, m, body-fixed.</param>
    public Vector3D Smooth(FacetId facet, Vector3D facetNormal, Vector3D point, Vector3D camera)
    {
        Vector3D normal = _normals.At(facet, facetNormal, point);
        return Vector3D.Dot(normal, camera - point) > 0.0 ? normal : facetNormal;
    }

    /// <summary>Computes the radiance factors of <see cref="Points"/>.</summary>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="options">Reflectance law and map.</param>
    /// <param name="scales">By what the map multiplies the law's radiance factors, by column; empty to read the map.</param>
    public void FindFactors(
        FrameCamera camera, SceneLight light, NativeRenderOptions options, ReadOnlySpan<double> scales = default)
    {
        Points.FindAngles(light.PositionBodyFixed, camera.PositionBodyFixed);
        FindLawFactors(Points, options);
        if (scales.IsEmpty)
        {
            Scale(camera, options);
            return;
        }

        for (int i = 0; i < Points.Count; i++)
        {
            Points.Factors[i] *= scales[Points.Columns[i]];
        }
    }

    /// <summary>Computes by what the map multiplies the law's radiance factors of points, whatever the light; 1 without a map.</summary>
    public void FindScales(FrameCamera camera, NativeRenderOptions options)
    {
        if (options.Hapke is { } places && options.Albedo is { } map)
        {
            places.FindReferenceFactors(Points, map.Reference);
        }

        Points.Factors.AsSpan(0, Points.Count).Fill(1.0);
        Scale(camera, options);
    }

    /// <summary>Computes the radiance factors of the law alone.</summary>
    /// <param name="points">The points, with their angles; get the radiance factors.</param>
    /// <param name="options">Reflectance law; with Hapke's maps also the map of the reflectance.</param>
    public static void FindLawFactors(SunlitPoints points, NativeRenderOptions options)
    {
        if (options.Hapke is { } places)
        {
            places.FindFactors(points, options.Albedo?.Reference);
            return;
        }

        int count = points.Count;
        options.Reflectance.RadianceFactors(
            points.CosIncidence.AsSpan(0, count), points.CosEmission.AsSpan(0, count), points.PhaseHaversine.AsSpan(0, count),
            points.Factors);
    }

    private void Scale(FrameCamera camera, NativeRenderOptions options)
    {
        int count = Points.Count;
        bool hasSites = options.AlbedoSites.Count > 0;
        if (hasSites)
        {
            _ofLaw = _ofLaw.Length < count ? new double[Points.Factors.Length] : _ofLaw;
            Points.Factors.AsSpan(0, count).CopyTo(_ofLaw);
        }

        if (options.Albedo is { } map)
        {
            _albedo.Scale(
                Points, camera, 1.0 / options.SubsamplesPerAxis, map, FactorOf(options, map.Reference), hasSites ? _ofLaw : Points.Factors);
        }

        surface.Brightness?.Scale(
            Points.X.AsSpan(0, count), Points.Y.AsSpan(0, count), Points.Z.AsSpan(0, count), Points.Factors.AsSpan(0, count));
        if (hasSites)
        {
            ScaleBySites(camera, options);
        }
    }

    /// <summary>The law's radiance factor in a geometry; null if it differs from place to place.</summary>
    private static double? FactorOf(NativeRenderOptions options, ReferenceGeometry there) => options.Hapke is null
        ? options.Reflectance.RadianceFactor(there.CosIncidence, there.CosEmission, there.PhaseHaversine)
        : null;

    /// <summary>
    /// Scales the law's radiance factors anew by the sites where they have data: real ones, without invented rays.
    /// </summary>
    private void ScaleBySites(FrameCamera camera, NativeRenderOptions options)
    {
        int count = Points.Count;
        ReferenceGeometry? there = options.Albedo?.Reference;
        foreach (AlbedoMap site in options.AlbedoSites)
        {
            if (!site.MayHold(Points.X.AsSpan(0, count), Points.Y.AsSpan(0, count), Points.Z.AsSpan(0, count)))
            {
                continue;
            }

            if (site.Reference != there)
            {
                there = site.Reference;
                options.Hapke?.FindReferenceFactors(Points, site.Reference);
            }

            _albedo.Scale(Points, camera, 1.0 / options.SubsamplesPerAxis, site, FactorOf(options, site.Reference), _ofLaw, isSite: true);
        }
    }
}
