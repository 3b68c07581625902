namespace Msisf.Core.Tiles;

/// <summary>The squares that a set of parts covers, at any level.</summary>
public sealed class PartArea
{
    private readonly HashSet<SurfacePart> _squares = [];
    private readonly HashSet<SurfacePart> _around = [];

    /// <summary>Takes the parts.</summary>
    public PartArea(IEnumerable<SurfacePart> parts)
    {
        foreach (SurfacePart part in parts)
        {
            SurfacePart square = part with { Level = 0 };
            _squares.Add(square);
            while (square.Subdivisions > 1 && _around.Add(square = square.Around()))
            {
                // Goes up to the tile, or to a square that was already added.
            }
        }
    }

    /// <summary>Whether the part's square overlaps one of these squares.</summary>
    public bool Overlaps(SurfacePart part)
    {
        SurfacePart square = part with { Level = 0 };
        if (_around.Contains(square))
        {
            return true;
        }

        bool isIn = _squares.Contains(square);
        while (!isIn && square.Subdivisions > 1)
        {
            square = square.Around();
            isIn = _squares.Contains(square);
        }

        return isIn;
    }
}
