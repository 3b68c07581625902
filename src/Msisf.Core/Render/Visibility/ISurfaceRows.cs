using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>Surface points, in rows, that light and shade are found for: those of an image's pixels, or of parts of pixels.</summary>
internal interface ISurfaceRows
{
    /// <summary>Maximum number of points in a row.</summary>
    int Width { get; }

    /// <summary>Number of rows.</summary>
    int Height { get; }

    /// <summary>The frame's projection.</summary>
    ImageView View { get; }

    /// <summary>Computes the surface points of a row.</summary>
    /// <param name="y">1 to the height.</param>
    /// <param name="row">Receives the points.</param>
    /// <param name="withNormals">Whether the normals are wanted; without them it takes two thirds of the time.</param>
    void Read(int y, SurfaceRow row, bool withNormals = true);

    /// <summary>The facet of a point of a row.</summary>
    /// <param name="y">The row that was read.</param>
    /// <param name="number">From <see cref="SurfaceRow.Facets"/>.</param>
    FacetId FacetOf(int y, int number);
}
