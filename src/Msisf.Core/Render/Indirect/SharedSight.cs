using System.Collections.Concurrent;
using System.Runtime.Intrinsics;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Which bright points of the ground some pixels of an image see that lie far apart: most of what the pixels between them see is the
/// same.
/// </summary>
internal sealed class SharedSight
{
    /// <summary>px: how far apart the pixels are at most, and at least.</summary>
    private const int MostStep = 32;
    private const int LeastStep = 8;

    /// <summary>Into how many parts they divide the longer side of an image at least, and at most, where the step allows it.</summary>
    private const int FewestParts = 16;
    private const int MostParts = 64;

    /// <summary>Pixels that are looked from together are in squares with sides of so many.</summary>
    private const int Edge = 8;

    /// <summary>Bytes: more brightness is not kept, but found again.</summary>
    private const long MostKept = 128 << 20;

    /// <summary>Words of bits, one bit a light, that are found at once.</summary>
    private const int Chunk = 16;

    private readonly GroundLights _lights;
    private readonly int[] _x;
    private readonly int[] _y;
    private readonly int _words;
    private readonly ulong[] _facing;
    private readonly ulong[] _seen;
    private readonly SurfacePoint?[] _ground;
    private readonly ConcurrentDictionary<int, float[]> _powers = new();

    private SharedSight(GroundLights lights, int width, int height)
    {
        int longer = Math.Max(width, height);
        int step = Math.Max(Math.Clamp(longer / FewestParts, LeastStep, MostStep), (longer + MostParts - 1) / MostParts);
        (_lights, _x, _y) = (lights, Places(width, step), Places(height, step));
        _words = (lights.Bright.Length + 63) / 64;
        _facing = new ulong[_x.Length * _y.Length * _words];
        _seen = new ulong[_facing.Length];
        _ground = new SurfacePoint?[_x.Length * _y.Length];
    }

    /// <summary>Looks from the pixels of an image to the bright points.</summary>
    /// <param name="image">The image.</param>
    /// <param name="tree">The ground.</param>
    /// <param name="lights">Its points.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <param name="advance">Is told, from any thread, which further part of the work is done; null for nobody.</param>
    public static SharedSight Find(
        ISurfaceRows image, GroundTree tree, GroundLights lights, int threads, CancellationToken cancellation,
        Action<double>? advance = null)
    {
        SharedSight sight = new(lights, image.Width, image.Height);
        sight.Read(image);
        int across = (sight._x.Length + Edge - 1) / Edge;
        int squares = across * ((sight._y.Length + Edge - 1) / Edge);
        int chunks = (sight._words + Chunk - 1) / Chunk;
        WorkerTeam.Run(threads, squares * chunks, (_, item) =>
        {
            (int square, int chunk) = (item / chunks, item % chunks);
            sight.Look(new GroupSight(tree, lights), square % across * Edge, square / across * Edge, chunk * Chunk);
            advance?.Invoke(1.0 / (squares * chunks));
        }, cancellation);
        return sight;
    }

    /// <summary>How bright the bright points are towards the point that one of the pixels next to a place in the image shows.</summary>
    /// <param name="x">px, from 0.</param>
    /// <param name="y">px, from 0.</param>
    /// <param name="find">Finds it towards a point, m, body-fixed.</param>
    /// <returns>As <see cref="LightPowers.Towards"/>; null if the pixel shows no ground.</returns>
    public float[]? PowersTowards(double x, double y, Func<Vector3D, float[]> find)
    {
        (int left, float right) = Between(_x, x);
        (int top, float down) = Between(_y, y);
        int pixel = ((top + (down > 0.5f ? 1 : 0)) * _x.Length) + left + (right > 0.5f ? 1 : 0);
        if (_ground[pixel] is not { } ground)
        {
            return null;
        }

        bool hasRoom = 4L * _lights.Bright.PaddedLength * _powers.Count < MostKept;
        return hasRoom ? _powers.GetOrAdd(pixel, _ => find(ground.Point)) : _powers.GetValueOrDefault(pixel) ?? find(ground.Point);
    }

    /// <summary>Tells what a place in the image sees, by the four pixels around it.</summary>
    /// <param name="x">px, from 0.</param>
    /// <param name="y">px, from 0.</param>
    /// <param name="seen">
    /// Receives for each bright point how likely it is seen; 0 if no pixel tells. <see cref="BrightLights.PaddedLength"/> elements.
    /// </param>
    /// <param name="isUnsure">Receives as many, 1 where the pixels say different things, or nothing, otherwise 0.</param>
    public void Mix(double x, double y, Span<float> seen, Span<float> isUnsure)
    {
        (int left, float right) = Between(_x, x);
        (int top, float down) = Between(_y, y);
        int first = (top * _x.Length) + left;
        ReadOnlySpan<int> pixels = [first, first + 1, first + _x.Length, first + _x.Length + 1];
        ReadOnlySpan<float> weights = [(1 - right) * (1 - down), right * (1 - down), (1 - right) * down, right * down];
        for (int light = 0; light < seen.Length; light += Vector512<float>.Count)
        {
            (Vector512<float> known, Vector512<float> sum) = (Vector512<float>.Zero, Vector512<float>.Zero);
            for (int i = 0; i < pixels.Length; i++)
            {
                int at = (pixels[i] * _words) + (light / 64);
                known += Weighted(_facing[at] >> (light % 64), weights[i]);
                sum += Weighted(_seen[at] >> (light % 64), weights[i]);
            }

            Vector512<float> isKnown = Vector512.GreaterThan(known, Vector512<float>.Zero);
            Vector512<float> isSure = isKnown
                & (Vector512.Equals(sum, Vector512<float>.Zero) | Vector512.GreaterThanOrEqual(sum, known));
            Vector512.ConditionalSelect(isKnown, sum / known, Vector512<float>.Zero).CopyTo(seen[light..]);
            Vector512.ConditionalSelect(isSure, Vector512<float>.Zero, Vector512<float>.One).CopyTo(isUnsure[light..]);
        }
    }

    /// <summary>The weight where one of sixteen bits is set, otherwise 0.</summary>
    private static Vector512<float> Weighted(ulong bits, float weight)
    {
        Vector512<uint> ofLane = Vector512.Create(1u, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
        Vector512<uint> isSet = Vector512.Equals(Vector512.Create((uint)bits) & ofLane, ofLane);
        return Vector512.ConditionalSelect(isSet.AsSingle(), Vector512.Create(weight), Vector512<float>.Zero);
    }

    /// <summary>Reads what the pixels show.</summary>
    private void Read(ISurfaceRows image)
    {
        SurfaceRow row = new();
        for (int pixel = 0; pixel < _ground.Length; pixel++)
        {
            if (pixel % _x.Length == 0)
            {
                image.Read(_y[pixel / _x.Length] + 1, row);
            }

            int i = Array.BinarySearch(row.Columns, 0, row.Count, _x[pixel % _x.Length]);
            _ground[pixel] = i < 0 ? null : new SurfacePoint(
                new Vector3D(row.X[i], row.Y[i], row.Z[i]), new Vector3D(row.NormalX[i], row.NormalY[i], row.NormalZ[i]));
        }
    }

    /// <summary>From 0 to the last pixel, two of them at least.</summary>
    private static int[] Places(int size, int step) =>
        [.. Enumerable.Range(0, Math.Max(2, ((size - 2 + step) / step) + 1)).Select(i => Math.Min(i * step, size - 1))];

    private static (int Before, float Part) Between(int[] places, double at)
    {
        int before = 0;
        while (before < places.Length - 2 && places[before + 1] <= at)
        {
            before++;
        }

        double width = Math.Max(1, places[before + 1] - places[before]);
        return (before, (float)Math.Clamp((at - places[before]) / width, 0.0, 1.0));
    }

    /// <summary>Looks from a square of the pixels to some of the bright points.</summary>
    private void Look(GroupSight sight, int left, int top, int firstWord)
    {
        for (int row = top; row < Math.Min(top + Edge, _y.Length); row++)
        {
            for (int column = left; column < Math.Min(left + Edge, _x.Length); column++)
            {
                int pixel = (row * _x.Length) + column;
                if (_ground[pixel] is { } ground)
                {
                    sight.Group.Add(ground.Point, ground.Facet, ground.Facet, default, _lights.ReachOfView, pixel);
                }
            }
        }

        sight.Begin();
        for (int light = firstWord * 64; light < Math.Min((firstWord + Chunk) * 64, _lights.Bright.Length); light++)
        {
            ulong facing = sight.Facing(_lights.Bright[light]);
            ulong seeing = sight.Seeing(_lights.Bright[light], facing);
            for (int pixel = 0; pixel < sight.Group.Count; pixel++)
            {
                int at = ((int)sight.Group.Numbers[pixel] * _words) + (light / 64);
                _facing[at] |= ((facing >> pixel) & 1) << (light % 64);
                _seen[at] |= ((seeing >> pixel) & 1) << (light % 64);
            }
        }
    }

    /// <summary>What a pixel shows.</summary>
    /// <param name="Point">m, body-fixed.</param>
    /// <param name="Facet">Normal of its facet, length 1.</param>
    private readonly record struct SurfacePoint(Vector3D Point, Vector3D Facet);
}
