using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>Surface points, in rows, that light and shade are found for: those of an image's pixels, or of parts of pixels.</summary>
internal interface ISurfaceRows
{
    /// <summary>Maximum number of points in a row.</summary>
    int Width { get; }

    int Height { get; }

    /// <summary>The frame's projection.</summary>
    ImageView View { get; }

    /// <summary>Computes the surface points of a row.</summary>
    /// <param name="y">1 to the height.</param>
    /// <param name="row">Receives the points.</param>
    void Read(int y, SurfaceRow row);

    /// <summary>Computes some surface points of a row, without unit normals: the same points as <see cref="Read"/>, bit for bit.</summary>
    /// <param name="y">1 to the height.</param>
    /// <param name="columns">Their columns, from 0; all show the surface.</param>
    /// <param name="row">Receives the points; its normals are not to be used.</param>
    void ReadPoints(int y, ReadOnlySpan<int> columns, SurfaceRow row);

    /// <summary>The facet of a point of a row.</summary>
    /// <param name="y">The row that was read.</param>
    /// <param name="number">From <see cref="SurfaceRow.Facets"/>.</param>
    FacetId FacetOf(int y, int number);
}
