using System.Runtime.CompilerServices;
using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Visibility;

/// <summary>The facets that have been the nearest one somewhere in a band. One object is used for many bands.</summary>
internal sealed class FacetRecords
{
    private const int FirstCapacity = 1024;

    private readonly RecentUse _use = new();
    private FacetRecord[] _records = [];

    public int Count { get; private set; }

    /// <summary>Bytes of the buffers that were replaced by smaller or larger ones.</summary>
    public long ReplacedBytes { get; private set; }

    /// <summary>A facet by its number.</summary>
    public ref readonly FacetRecord this[int number] => ref AsSpan()[number];

    /// <summary>The facets in the order of their numbers.</summary>
    public ReadOnlySpan<FacetRecord> AsSpan() => _records.AsSpan(0, Count);

    /// <summary>Forgets all facets.</summary>
    public void Clear() => Count = 0;

    /// <summary>Gives back memory that the last frames did not need; called once a frame, before the facets are forgotten.</summary>
    public void Trim()
    {
        int length = _records.Length;
        if (_use.Note(Count, ref length))
        {
            ReplacedBytes += Unsafe.SizeOf<FacetRecord>() * (long)_records.Length;
            _records = GC.AllocateUninitializedArray<FacetRecord>(length);
        }
    }

    /// <summary>
    /// Says how many facets the first band may have; later ones find the room of those before. A buffer that only doubles leaves as much
    /// memory behind as it has at last.
    /// </summary>
    public void Expect(int facets)
    {
        if (_records.Length == 0)
        {
            MakeRoom(facets);
        }
    }

    /// <summary>Records a facet and returns its number.</summary>
    /// <param name="index">Index in the block of the north-western vertex of the facet's cell.</param>
    /// <param name="half">0: the south-western facet, 1: the north-eastern one.</param>
    public int Add(ProjectedBlock block, int index, int half)
    {
        if (Count == _records.Length)
        {
            MakeRoom(Math.Max(FirstCapacity, 2 * Count));
        }

        block.Record(index, half, out _records[Count++]);
        return Count - 1;
    }

    private void MakeRoom(int facets)
    {
        ReplacedBytes += Unsafe.SizeOf<FacetRecord>() * (long)_records.Length;
        FacetRecord[] larger = GC.AllocateUninitializedArray<FacetRecord>(facets);
        AsSpan().CopyTo(larger);
        _records = larger;
    }
}
