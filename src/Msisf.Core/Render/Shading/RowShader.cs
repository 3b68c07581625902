using System.Buffers.Binary;
using System.Buffers;
using System.Collections.Concurrent;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render.Shading;

/// <summary>Computes the radiance factor of each pixel from the surface it shows. Safe for several threads.</summary>
internal sealed class RowShader
{
    /// <summary>Eight pixels that terrain hides from the light, as <see cref="PixelSunlight.Hidden"/> has them.</summary>
    private const ulong AllHidden = 0x0101_0101_0101_0101;

    private SurfaceModel _surface;
    private readonly ConcurrentBag<RowReflection> _idle = [];
    private double[] _reflected = [];

    public RowShader(SurfaceModel surface) => _surface = surface;

    /// <summary>Shades another surface from the next frame on; the memory of pixels is kept.</summary>
    public void Show(SurfaceModel surface)
    {
        _surface = surface;
        _idle.Clear();
    }

    /// <summary>
    /// Whether <see cref="Reflect"/> is to be called for each row when its points are read for the shadows, which saves to compute them
    /// again: the shadows then only switch pixels off. With the Sun's disc they change the incidence angle, and smooth normals cost more
    /// than reading again where most pixels are in shadow.
    /// </summary>
    /// <param name="options">Reflectance law and kind of normals.</param>
    public bool ReflectsFirst(NativeRenderOptions options, bool hasDisc) =>
        options.Normals == NormalModel.Facet && !hasDisc && !IsFlat(options);

    /// <summary>Makes room for the factors of <see cref="Reflect"/>.</summary>
    public void Prepare(int pixels)
    {
        if (_reflected.Length < pixels)
        {
            _reflected = new double[pixels];
        }
    }

    /// <summary>Keeps the radiance factors that the pixels of a row have if nothing hides the light from them.</summary>
    /// <param name="visible">The surface points that the pixels show.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="options">Reflectance law.</param>
    /// <param name="row">Index of the row, from 0.</param>
    /// <param name="pixels">Its points.</param>
    /// <param name="cosIncidence">The cosines of their incidence angles.</param>
    public void Reflect(
        ISurfaceRows visible, SceneLight light, NativeRenderOptions options, int row, SurfaceRow pixels, double[] cosIncidence)
    {
        RowReflection reflection = Take();
        reflection.TakeFacing(pixels, cosIncidence, visible.Width);
        reflection.FindFactors(visible.View.Camera, light, options);
        SunlitPoints points = reflection.Points;
        Span<double> reflected = _reflected.AsSpan(row * visible.Width, visible.Width);
        if (points.Count == reflected.Length)
        {
            points.Factors.AsSpan(0, reflected.Length).CopyTo(reflected);
        }
        else
        {
            for (int i = 0; i < points.Count; i++)
            {
                reflected[points.Columns[i]] = points.Factors[i];
            }
        }

        _idle.Add(reflection);
    }

    /// <summary>Computes the radiance factors of points.</summary>
    /// <param name="visible">The surface points that the pixels show.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="sunlight">The light on each pixel.</param>
    /// <param name="options">Reflectance law and kind of normals.</param>
    /// <param name="scales">By what the map multiplies the law's radiance factors; empty to read the map.</param>
    /// <param name="radianceFactors">
    /// Receives the radiance factor (I/F) of each pixel, row by row. May be the memory of the cosines: a row is emptied only when it is
    /// shaded, while it is in the processor's cache.
    /// </param>
    public void Shade(
        ISurfaceRows visible,
        SceneLight light,
        PixelSunlight sunlight,
        NativeRenderOptions options,
        double[] scales,
        double[] radianceFactors,
        int threads,
        CancellationToken cancellation)
    {
        bool isFlat = IsFlat(options);
        bool isReflected = ReflectsFirst(options, sunlight.VisibleFractions.Length > 0);
        WorkerTeam.Run(threads, visible.Height, (_, row) =>
        {
            int start = row * visible.Width;
            Span<double> factors = radianceFactors.AsSpan(start, visible.Width);
            if (isFlat || isReflected)
            {
                double[] rented = ArrayPool<double>.Shared.Rent(factors.Length);
                Span<double> cosines = rented.AsSpan(0, factors.Length);
                sunlight.CosIncidence.AsSpan(start, factors.Length).CopyTo(cosines);
                factors.Clear();
                if (isFlat)
                {
                    AddFlat(sunlight, start, cosines, options.Reflectance, factors);
                }
                else
                {
                    AddReflected(sunlight, start, cosines, _reflected.AsSpan(start, factors.Length), factors);
                }

                ArrayPool<double>.Shared.Return(rented);
                return;
            }

            RowReflection reflection = Take();
            reflection.TakeLit(visible, row, light, sunlight, options.Normals);
            factors.Clear();
            reflection.FindFactors(
                visible.View.Camera, light, options, scales.Length > 0 ? scales.AsSpan(start, visible.Width) : default);
            SunlitPoints points = reflection.Points;
            for (int i = 0; i < points.Count; i++)
            {
                factors[points.Columns[i]] += points.Weights[i] * points.Factors[i];
            }

            _idle.Add(reflection);
        }, cancellation);
    }

    /// <summary>Whether the brightness of the ground depends on its place, beside the law.</summary>
    public bool HasMap(NativeRenderOptions options) => HasRays || options.HasMap;

    /// <summary>Whether craters of invented ground have bright rays.</summary>
    public bool HasRays => _surface.Brightness is not null;

    /// <inheritdoc cref="RowReflection.FindScales(FrameCamera, SurfaceRow, double[], double, NativeRenderOptions, Span{double})"/>
    public void FindScales(
        FrameCamera camera, SurfaceRow row, double[] cosIncidence, double minCosine, NativeRenderOptions options, Span<double> scales)
    {
        RowReflection reflection = Take();
        reflection.FindScales(camera, row, cosIncidence, minCosine, options, scales);
        _idle.Add(reflection);
    }

    /// <summary>The smooth normal at a point, as it is used for shading; length 1, body-fixed, or the facet's normal.</summary>
    /// <param name="hit">The point, with its facet's normal.</param>
    /// <param name="cameraBodyFixed">The camera's position, m, body-fixed.</param>
    public Vector3D SmoothNormal(SurfaceHit hit, Vector3D cameraBodyFixed)
    {
        RowReflection scratch = Take();
        Vector3D normal = scratch.Smooth(hit.Facet, hit.NormalBodyFixed, hit.PointBodyFixed, cameraBodyFixed);
        _idle.Add(scratch);
        return normal;
    }

    /// <summary>Whether the brightness of lit ground follows from the facet and the Sun alone.</summary>
    public bool IsFlat(NativeRenderOptions options) => _surface.Brightness is null
        && options is { Normals: NormalModel.Facet, Reflectance.DependsOnViewer: false, HasMap: false, Hapke: null };

    private RowReflection Take() => _idle.TryTake(out RowReflection? idle) ? idle : new RowReflection(_surface);

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private static void AddReflected(
        PixelSunlight sunlight, int start, ReadOnlySpan<double> cosines, ReadOnlySpan<double> reflected, Span<double> factors)
    {
        ReadOnlySpan<byte> hidden = sunlight.Hidden.AsSpan(start, factors.Length);
        int column = 0;
        for (; column <= factors.Length - Vector512<double>.Count; column += Vector512<double>.Count)
        {
            ulong eight = BinaryPrimitives.ReadUInt64LittleEndian(hidden[column..]);
            if (eight == 0)
            {
                Vector512<double> isLit = Vector512.GreaterThan(Vector512.Create(cosines[column..]), Vector512<double>.Zero);
                Vector512<double> added = isLit & Vector512.Create(reflected[column..]);
                (Vector512.Create((ReadOnlySpan<double>)factors[column..]) + added).CopyTo(factors[column..]);
            }
            else if (eight != AllHidden)
            {
                AddReflected(cosines, hidden, reflected, factors, column, column + Vector512<double>.Count);
            }
        }

        AddReflected(cosines, hidden, reflected, factors, column, factors.Length);
    }

    private static void AddReflected(
        ReadOnlySpan<double> cosines, ReadOnlySpan<byte> hidden, ReadOnlySpan<double> reflected, Span<double> factors,
        int first, int end)
    {
        for (int column = first; column < end; column++)
        {
            if (hidden[column] == 0 && cosines[column] > 0.0)
            {
                factors[column] += reflected[column];
            }
        }
    }

    private static void AddFlat(
        PixelSunlight sunlight, int start, ReadOnlySpan<double> cosines, IReflectance law, Span<double> factors)
    {
        if (sunlight.VisibleFractions.Length == 0 && law is LambertReflectance { Albedo: var albedo })
        {
            double[] reflected = ArrayPool<double>.Shared.Rent(factors.Length);
            for (int column = 0; column < cosines.Length; column++)
            {
                reflected[column] = albedo * cosines[column];
            }

            AddReflected(sunlight, start, cosines, reflected.AsSpan(0, factors.Length), factors);
            ArrayPool<double>.Shared.Return(reflected);
            return;
        }

        ReadOnlySpan<byte> hidden = sunlight.Hidden.AsSpan(start, factors.Length);
        bool isPoint = sunlight.VisibleFractions.Length == 0;
        for (int column = 0; column < factors.Length; column++)
        {
            if (hidden[column] == 0 && cosines[column] > 0.0)
            {
                double share = isPoint ? 1.0 : sunlight.VisibleFractions[start + column];
                factors[column] += share * law.RadianceFactor(cosines[column], cosEmission: 1.0, phaseHaversine: 0.0);
            }
        }
    }
}
