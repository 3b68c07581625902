using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tests.Support;

/// <summary>What each pixel's ray meets, with all tiles or with some: a pixel is black, or lit, and then a facet's.</summary>
internal sealed class BruteForceImage
{
    private readonly BruteForceMoon.FacetId?[] _lit;
    private readonly int _width;

    /// <param name="moon">All facets.</param>
    /// <param name="camera">A ray through the middle of each pixel.</param>
    /// <param name="sun">m, MOON_ME.</param>
    /// <param name="isThere">By tile (row 0 northernmost); null: all.</param>
    /// <param name="rows">The others stay black; null: all.</param>
    public BruteForceImage(BruteForceMoon moon, PinholeCamera camera, Vector3D sun, bool[]? isThere, PixelRows? rows = null)
    {
        _width = camera.Width;
        HitTiles = new bool[moon.TileCount];
        _lit = new BruteForceMoon.FacetId?[camera.Width * camera.Height];
        PixelRows wanted = rows ?? new PixelRows(0, camera.Height);
        for (int pixel = wanted.First * _width; pixel < wanted.End * _width; pixel++)
        {
            Ray ray = camera.RayThrough((pixel % camera.Width) + 1, (pixel / camera.Width) + 1);
            if (moon.FirstHit(ray.Origin, ray.Direction, isThere) is not (BruteForceMoon.FacetId facet, double t))
            {
                continue;
            }

            HitTiles[moon.TileOf(facet)] = true;
            Vector3D point = ray.Origin + (t * ray.Direction);
            Vector3D normal = moon.Normal(facet);

            // As POV-Ray does, the side that the ray comes to is the one that is lit or not.
            Vector3D seenNormal = Vector3D.Dot(normal, ray.Direction) > 0.0 ? -normal : normal;
            if (Vector3D.Dot(seenNormal, sun - point) > 0.0 && !moon.IsShadowed(facet, point, sun, isThere))
            {
                _lit[pixel] = facet;
            }
        }
    }

    /// <summary>Tiles that any ray met first.</summary>
    public bool[] HitTiles { get; }

    /// <summary>Lit pixels.</summary>
    public int Lit => _lit.Count(facet => facet is not null);

    /// <summary>Pixels that differ.</summary>
    public int DifferencesFrom(BruteForceImage other) => _lit.Zip(other._lit).Count(pair => pair.First != pair.Second);

    /// <summary>Pixels of some rows that differ.</summary>
    public int DifferencesFrom(BruteForceImage other, PixelRows rows) =>
        _lit.Zip(other._lit).Skip(rows.First * _width).Take((rows.End - rows.First) * _width).Count(pair => pair.First != pair.Second);
}
