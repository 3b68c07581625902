using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>CK type 6, ESOC's: pieces one after another, each with quaternions and polynomials of its own kind.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 6".</remarks>
internal sealed class CkPieces : CkSegment
{
    private readonly bool _isLaterAtBorder;
    private readonly Lazy<(double[] Bounds, Piece[] Pieces)> _pieces;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="Core.Errors.BadInputException">They contradict each other.</exception>
    public CkPieces(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count);
        _isLaterAtBorder = Words.Whole(fromEnd: 2, min: -1, max: 1) == 1;
        _pieces = new Lazy<(double[], Piece[])>(() => ReadPieces(count));
    }

    public override IReadOnlyList<TdbInterval> Intervals =>
    [
        .. _pieces.Value.Pieces.Select((piece, i) => new TdbInterval(
            _pieces.Value.Bounds[i],
            Math.Max(_pieces.Value.Bounds[i], Math.Min(_pieces.Value.Bounds[i + 1], piece.Ticks[^1])))),
    ];

    protected override RotationMatrix? Evaluate(double ticks)
    {
        (double[] bounds, Piece[] pieces) = _pieces.Value;
        int index = LastAtOrBefore(bounds, ticks);
        if (index >= 0 && index < bounds.Length && bounds[index] == ticks && !_isLaterAtBorder)
        {
            index--;
        }

        Piece piece = pieces[Math.Clamp(index, 0, pieces.Length - 1)];
        return ticks >= piece.Ticks[0] && ticks <= piece.Ticks[^1]
            ? Matrix(piece.Polynomials.At(ticks, piece.Ticks, piece.First))
            : null;
    }

    private (double[] Bounds, Piece[] Pieces) ReadPieces(int count)
    {
        // At the end: bounds of the pieces, their directory, where the pieces begin, and two numbers.
        double[] begins = Words.Read(Words.Count - 3 - count, count + 1);
        double[] bounds = Words.ReadRising(Words.Count - 4 - (2L * count) - (count / 100), count + 1);
        Piece[] pieces = new Piece[count];
        for (int i = 0; i < count; i++)
        {
            if (!(begins[i] >= 1.0 && begins[i + 1] > begins[i] + 4.0 && begins[i + 1] <= Words.Count))
            {
                throw Words.Damaged("a piece has no place");
            }

            (long first, long end) = ((long)begins[i] - 1, (long)begins[i + 1] - 1);
            CkPolynomials polynomials = CkPolynomials.Read(Words, end - 1);
            int packets = Words.Whole((int)(Words.Count - end) + 1, min: 1, (end - first) / (polynomials.Packet + 1));
            pieces[i] = new Piece(polynomials, first, Words.ReadRising(first + ((long)packets * polynomials.Packet), packets));
        }

        return (bounds, pieces);
    }

    private sealed record Piece(CkPolynomials Polynomials, long First, double[] Ticks);
}
