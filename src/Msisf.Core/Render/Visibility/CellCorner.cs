namespace Msisf.Core.Render.Visibility;

/// <summary>A projected vertex.</summary>
/// <param name="X">Image column, px.</param>
/// <param name="Y">Image row, px.</param>
/// <param name="InverseDepth">1/m: inverse of its depth.</param>
internal readonly record struct CellCorner(double X, double Y, double InverseDepth)
{
    public CellCorner(ProjectedBlock block, int index)
        : this(block.X[index], block.Y[index], block.InverseDepth[index])
    {
    }
}
