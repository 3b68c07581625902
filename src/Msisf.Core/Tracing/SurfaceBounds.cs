using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tracing;

/// <summary>
/// Minimum and maximum radius of the surface in pages of 256 x 256 cells, blocks of 32 x 32 and patches of 8 x 8, each found when a ray
/// first comes near it. Safe for several threads: two may find the same bounds at the same time, which come out the same.
/// </summary>
internal sealed class SurfaceBounds
{
    private const int PageShift = 8;
    private const int BlockShift = 5;
    private const int PatchShift = 3;
    private const int BlocksAcrossPage = 1 << (PageShift - BlockShift);
    private const int PatchesAcrossBlock = 1 << (BlockShift - PatchShift);

    private readonly IElevationGrid _grid;
    private readonly LatticeMesh _mesh;
    private readonly int _pageColumns;
    private readonly Page?[] _pages;

    /// <summary>Takes the model; reads nothing of it.</summary>
    public SurfaceBounds(IElevationGrid grid, LatticeMesh mesh)
    {
        _grid = grid;
        _mesh = mesh;
        _pageColumns = PagesFor(mesh.Samples);
        _pages = new Page?[PagesFor(Rows) * _pageColumns];
    }

    /// <summary>Sides of a page, block, patch in cells: the kinds of <see cref="Of"/>.</summary>
    public static ReadOnlySpan<int> Sides => [1 << PageShift, 1 << BlockShift, 1 << PatchShift];

    /// <summary>Rows of cells, both fans included.</summary>
    private int Rows => _mesh.Lines + 1;

    /// <summary>Bounds of the page, block or patch that holds a cell.</summary>
    /// <param name="kind">Index into <see cref="Sides"/>.</param>
    /// <param name="row">As in <see cref="CellRectangle"/>.</param>
    /// <param name="column">As in <see cref="CellRectangle"/>.</param>
    /// <exception cref="BadInputException">The model can't be read there, or has a radius that is none of the Moon.</exception>
    public RadiusRange Of(int kind, int row, int column)
    {
        ref Page? page = ref _pages[((row >> PageShift) * _pageColumns) + (column >> PageShift)];
        Page found = Volatile.Read(ref page) ?? Publish(ref page, ReadPage(row >> PageShift, column >> PageShift));
        if (kind == 0)
        {
            return found.Range;
        }

        ref Block? block = ref found.Blocks[Index(row, column, BlockShift, BlocksAcrossPage)];
        Block inner = Volatile.Read(ref block) ?? Publish(ref block, ReadBlock(row >> BlockShift, column >> BlockShift));
        return kind == 1 ? inner.Range : inner.Patches[Index(row, column, PatchShift, PatchesAcrossBlock)];
    }

    private static int PagesFor(int cells) => (cells + (1 << PageShift) - 1) >> PageShift;

    private static int Index(int row, int column, int shift, int across) =>
        (((row >> shift) % across) * across) + ((column >> shift) % across);

    private static T Publish<T>(ref T? place, T made)
        where T : class
    {
        Volatile.Write(ref place, made);
        return made;
    }

    private Page ReadPage(int pageRow, int pageColumn)
    {
        // The vertices of row r are those of the lines r - 1 and r; beyond the first and last line there is a pole.
        int north = (pageRow << PageShift) - 1;
        int south = Math.Min((pageRow + 1) << PageShift, Rows) - 1;
        int first = Math.Max(north, 0);
        int last = Math.Min(south, _mesh.Lines - 1);
        int west = pageColumn << PageShift;
        int samples = Math.Min(1 << PageShift, _mesh.Samples - west) + 1;
        (double min, double max) = _grid.RadiusBounds(first, last - first + 1, west, Math.Min(samples, _mesh.Samples));
        if (!(
            Math.Abs(min - MoonConstants.ReferenceRadius) <= MoonConstants.MaxRelief
                && Math.Abs(max - MoonConstants.ReferenceRadius) <= MoonConstants.MaxRelief))
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{_grid.ProductId} has radii from {min:R} to {max:R} m between its lines {first + 1} and {last + 1}, "
                    + $"samples {west + 1} and {Math.Min(west + samples, _mesh.Samples)}; "
                    + $"a surface within {MoonConstants.MaxRelief:R} m of {MoonConstants.ReferenceRadius:R} m is needed. "
                    + $"Check the model and its label."));
        }

        RadiusRange range = RadiusRange.Around(min, max);
        range = north < first ? range.With(PoleRadius(north)) : range;
        return new Page(south > last ? range.With(PoleRadius(south)) : range);
    }

    private double PoleRadius(int line)
    {
        Span<double> radius = stackalloc double[1];
        _mesh.ReadRadii(line, 0, radius);
        return radius[0];
    }

    private Block ReadBlock(int blockRow, int blockColumn)
    {
        int firstRow = blockRow << BlockShift;
        int firstColumn = blockColumn << BlockShift;
        int rows = Math.Min(1 << BlockShift, Rows - firstRow);
        int columns = Math.Min(1 << BlockShift, _mesh.Samples - firstColumn);
        Span<double> radii = stackalloc double[columns + 1];
        Block block = new();
        for (int row = 0; row <= rows; row++)
        {
            _mesh.ReadRadii(firstRow + row - 1, firstColumn, radii);

            // A line between two patches belongs to both.
            int southern = Math.Min(row, rows - 1) >> PatchShift;
            block.Add(southern, radii);
            if (row > 0 && (row - 1) >> PatchShift != southern)
            {
                block.Add(southern - 1, radii);
            }
        }

        return block;
    }

    private sealed class Page(RadiusRange range)
    {
        public RadiusRange Range { get; } = range;

        public Block?[] Blocks { get; } = new Block?[BlocksAcrossPage * BlocksAcrossPage];
    }

    private sealed class Block
    {
        public Block() => Array.Fill(Patches, RadiusRange.Empty);

        public RadiusRange Range { get; private set; } = RadiusRange.Empty;

        public RadiusRange[] Patches { get; } = new RadiusRange[PatchesAcrossBlock * PatchesAcrossBlock];

        /// <summary>Adds a line of the block's vertices to a row of patches.</summary>
        public void Add(int patchRow, ReadOnlySpan<double> radii)
        {
            for (int first = 0; first < radii.Length - 1; first += 1 << PatchShift)
            {
                ref RadiusRange patch = ref Patches[(patchRow * PatchesAcrossBlock) + (first >> PatchShift)];
                foreach (double radius in radii[first..Math.Min(first + (1 << PatchShift) + 1, radii.Length)])
                {
                    patch = patch.With(radius);
                }

                Range = Range.With(patch);
            }
        }
    }
}
