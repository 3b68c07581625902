namespace Msisf.Core.Tiles;

/// <summary>The squares that some parts cover, whatever their levels.</summary>
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
                // Up to the tile, or to a square whose surroundings are known.
            }
        }
    }

    /// <summary>Whether the part's square has a piece in common with one of them.</summary>
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
