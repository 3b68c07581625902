using System.Buffers;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A part of a mapped file as memory of 16-bit codes; it lives as long as the mapping.</summary>
internal sealed unsafe class MappedCodes(ushort* start, int length) : MemoryManager<ushort>
{
    /// <inheritdoc/>
    public override Span<ushort> GetSpan() => new(start, length);

    /// <inheritdoc/>
    public override MemoryHandle Pin(int elementIndex = 0) => new(start + elementIndex);

    /// <inheritdoc/>
    public override void Unpin()
    {
    }

    /// <summary>Does nothing: the mapping belongs to <see cref="MapLevelsFile"/>.</summary>
    protected override void Dispose(bool disposing)
    {
    }
}
