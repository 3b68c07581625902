using System.Collections;
using System.Data.Common;

namespace MySqlConnector;

internal sealed class FakeParameters : DbParameterCollection
{
    private readonly List<FakeParameter> items = [];

    public override int Count => items.Count;

    public override object SyncRoot => items;

    public IReadOnlyDictionary<string, object> Values => items.ToDictionary(item => item.ParameterName, item => item.Value!);

    public override int Add(object value)
    {
        items.Add((FakeParameter)value);
        return items.Count - 1;
    }

    public override void AddRange(Array values) => throw new NotSupportedException();

    public override void Clear() => items.Clear();

    public override bool Contains(object value) => items.Contains((FakeParameter)value);

    public override bool Contains(string value) => IndexOf(value) >= 0;

    public override void CopyTo(Array array, int index) => ((ICollection)items).CopyTo(array, index);

    public override IEnumerator GetEnumerator() => items.GetEnumerator();

    public override int IndexOf(object value) => items.IndexOf((FakeParameter)value);

    public override int IndexOf(string parameterName) => items.FindIndex(item => item.ParameterName == parameterName);

    public override void Insert(int index, object value) => items.Insert(index, (FakeParameter)value);

    public override void Remove(object value) => items.Remove((FakeParameter)value);

    public override void RemoveAt(int index) => items.RemoveAt(index);

    public override void RemoveAt(string parameterName) => RemoveAt(IndexOf(parameterName));

    protected override DbParameter GetParameter(int index) => items[index];

    protected override DbParameter GetParameter(string parameterName) => items[IndexOf(parameterName)];

    protected override void SetParameter(int index, DbParameter value) => items[index] = (FakeParameter)value;

    protected override void SetParameter(string parameterName, DbParameter value) => items[IndexOf(parameterName)] = (FakeParameter)value;
}
