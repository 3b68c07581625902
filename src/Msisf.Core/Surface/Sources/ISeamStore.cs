namespace Msisf.Core.Surface.Sources;

/// <summary>Keeps what fills the gaps between models, since finding it takes long. Safe for several threads.</summary>
public interface ISeamStore
{
    /// <summary>What was kept for a gap; null if there is none.</summary>
    /// <param name="productId">Name of the finest model at the gap.</param>
    /// <param name="border">Hash of the last border of the gap.</param>
    GapTriangulation? Find(string productId, string border);

    /// <summary>Keeps what fills a gap.</summary>
    void Keep(GapTriangulation filling);
}
